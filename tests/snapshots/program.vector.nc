%
O0001
(==============================================================================)
(CYL_ROOT  for Fanuc, G43.5, by bladewright 0.1.0)
(Part     cylinder  file cylinder.obj)
(Hash     0123abcd)
(Job      made up for a test)
(Machine  demo_table_head)
(Tool     T1  ball end, R 5.0000 mm, half angle of taper 3.000 deg, shank R 8.000 mm, stick-out 70.000 mm from the ball)
(centre)
(Holder 1 R 20.000 mm, 40.000 mm long)
(Holder 2 R 30.000 mm, 25.000 mm long)
(Path     helix of 1 turns, 13 locations, 157.1 mm, blade axis x 20.000 to 20.500 mm)
(Scallop  0.01 mm asked for, chord tolerance 100 mm)
(Time     7.9 s of cutting)
(Verified before posting:)
(  ok     gouge: 0.000500 mm, limit 0.003000 mm)
(  ok     scallop: 0.010100 mm, limit 0.010500 mm)
(==============================================================================)
(X Y Z    tool TIP of the ball in the blade frame, mm: x along the blade axis from root to tip.)
(         Offset H1: from the gauge line to the TIP, planned as 140.0000 mm.)
(G54      origin of the blade frame at A=0: machine X 1400.0000 Y 0.0000 Z 0.0000, turned about X by 0.0000 deg.)
(I J K    tool axis from tip to spindle in the blade frame, all three on every line: one left out would count as 0.)
(F        G93, 1/min: each line takes 1/F minutes.)
N10 G17 G21 G40 G49 G80 G90 G94
N20 G53 G0 Z630.000
N30 T1 M6
N40 S6000 M3
N50 G0 A-72.8113 B5.0000
N60 G53 G0 X1452.521 Y7.388
N70 G54
(Down to the safe position, then along the tool axis)
N80 G43.5 H1
N90 G0 X22.8879 Y56.5342 Z9.7547 I0.08715574 J0.95170115 K0.29439566
N100 M8
N110 G1 X20.0000 Y25.0000 Z0.0000 I0.08715574 J0.95170115 K0.29439566 F5000
N120 G1 X19.5642 Y20.2415 Z-1.4720 I0.08715574 J0.95170115 K0.29439566 F300
(Cutting)
N130 G93
(Turn 1 of 1)
N140 G1 X19.6059 Y18.2656 Z8.8460 I0.08715574 J0.67699954 K0.73080470 F91.672783
N150 G1 X19.6476 Y11.3955 Z16.7937 I0.08715574 J0.22089645 K0.97139520 F91.672783
N160 G1 X19.6892 Y1.4720 Z20.2415 I0.08715574 J-0.29439566 K0.95170115 F91.672783
N170 G1 X19.7309 Y-8.8460 Z18.2656 I0.08715574 J-0.73080470 K0.67699954 F91.672783
N180 G1 X19.7726 Y-16.7937 Z11.3955 I0.08715574 J-0.97139520 K0.22089645 F91.672783
N190 G1 X19.8142 Y-20.2415 Z1.4720 I0.08715574 J-0.95170115 K-0.29439566 F91.672783
N200 G1 X19.8559 Y-18.2656 Z-8.8460 I0.08715574 J-0.67699954 K-0.73080470 F91.672783
N210 G1 X19.8976 Y-11.3955 Z-16.7937 I0.08715574 J-0.22089645 K-0.97139520 F91.672783
N220 G1 X19.9392 Y-1.4720 Z-20.2415 I0.08715574 J0.29439566 K-0.95170115 F91.672783
N230 G1 X19.9809 Y8.8460 Z-18.2656 I0.08715574 J0.73080470 K-0.67699954 F91.672783
N240 G1 X20.0226 Y16.7937 Z-11.3955 I0.08715574 J0.97139520 K-0.22089645 F91.672783
N250 G1 X20.0642 Y20.2415 Z-1.4720 I0.08715574 J0.95170115 K0.29439566 F91.672783
N260 G94
(Retract along the tool axis)
N270 G1 X20.5000 Y25.0000 Z0.0000 I0.08715574 J0.95170115 K0.29439566 F300
N280 G1 X23.3841 Y56.4927 Z9.7418 I0.08715574 J0.95170115 K0.29439566 F5000
N290 M9
N300 G49
N310 G53 G0 Z630.000
(Unwind of A: back to its first position, over all turns where A is a linear axis.)
N320 G0 A-72.8113
N330 M5
N340 M30
%
