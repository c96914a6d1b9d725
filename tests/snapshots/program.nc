%
O0001
(==============================================================================)
(CYL_ROOT  for Fanuc, G43.4, by bladewright 0.1.0)
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
(A        degrees, growing over all turns: A must be a linear axis to the control [ROT type B], or one that does not)
(roll over.)
(F        G93, 1/min: each line takes 1/F minutes.)
N10 G17 G21 G40 G49 G80 G90 G94
N20 G53 G0 Z630.000
N30 T1 M6
N40 S6000 M3
N50 G0 A-72.8113 B5.0000
N60 G53 G0 X1452.521 Y7.388
N70 G54
(Down to the safe position, then along the tool axis)
N80 G43.4 H1 X22.8879 Y56.5342 Z9.7547
N90 M8
N100 G1 X20.0000 Y25.0000 Z0.0000 F5000
N110 G1 X19.5642 Y20.2415 Z-1.4720 F300
(Cutting)
N120 G93
(Turn 1 of 1)
N130 G1 X19.6059 Y18.2656 Z8.8460 A-42.8113 F91.672783
N140 G1 X19.6476 Y11.3955 Z16.7937 A-12.8113 F91.672783
N150 G1 X19.6892 Y1.4720 Z20.2415 A17.1887 F91.672783
N160 G1 X19.7309 Y-8.8460 Z18.2656 A47.1887 F91.672783
N170 G1 X19.7726 Y-16.7937 Z11.3955 A77.1887 F91.672783
N180 G1 X19.8142 Y-20.2415 Z1.4720 A107.1887 F91.672783
N190 G1 X19.8559 Y-18.2656 Z-8.8460 A137.1887 F91.672783
N200 G1 X19.8976 Y-11.3955 Z-16.7937 A167.1887 F91.672783
N210 G1 X19.9392 Y-1.4720 Z-20.2415 A197.1887 F91.672783
N220 G1 X19.9809 Y8.8460 Z-18.2656 A227.1887 F91.672783
N230 G1 X20.0226 Y16.7937 Z-11.3955 A257.1887 F91.672783
N240 G1 X20.0642 Y20.2415 Z-1.4720 A287.1887 F91.672783
N250 G94
(Retract along the tool axis)
N260 G1 X20.5000 Y25.0000 Z0.0000 F300
N270 G1 X23.3841 Y56.4927 Z9.7418 F5000
N280 M9
N290 G49
N300 G53 G0 Z630.000
(Unwind of A: back to its first position, over all turns.)
N310 G0 A-72.8113
N320 M5
N330 M30
%
