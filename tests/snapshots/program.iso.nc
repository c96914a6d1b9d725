%
O0001
(==============================================================================)
(CYL_ROOT  for ISO, machine axes, by bladewright 0.1.0)
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
(X Y Z    positions of the machine's axes, mm: the tool's length, the head's pivot and the place of the part)
(         are in them. No length offset [G49]; G54 must be zero.)
(         The tool must stand out 140.0000 mm from the gauge line to its TIP; any other length cuts elsewhere.)
(A        degrees, growing over all turns: A must be a linear axis to the control.)
(F        G93, 1/min: each line takes 1/F minutes.)
N10 G17 G21 G40 G49 G80 G90 G94
N20 G54
N30 G53 G0 Z630.00000
N40 T1 M6
N50 G49
N60 S6000 M3
(Approach along the tool axis)
N70 G0 A-72.81127 B5.00000
N80 G0 X1452.52082 Y7.38801
N90 G0 X1452.52082 Y7.38801 Z195.59806
N100 M8
N110 G1 X1449.63295 Y7.38801 Z162.58961 F5000
N120 G1 X1449.19717 Y7.38801 Z157.60864 F300
(Cutting)
N130 G93
(Turn 1 of 1)
N140 G1 X1449.23884 Y7.38801 Z157.60864 A-42.81127 B5.00000 F91.672783
N150 G1 X1449.28051 Y7.38801 Z157.60864 A-12.81127 B5.00000 F91.672783
N160 G1 X1449.32217 Y7.38801 Z157.60864 A17.18873 B5.00000 F91.672783
N170 G1 X1449.36384 Y7.38801 Z157.60864 A47.18873 B5.00000 F91.672783
N180 G1 X1449.40551 Y7.38801 Z157.60864 A77.18873 B5.00000 F91.672783
N190 G1 X1449.44717 Y7.38801 Z157.60864 A107.18873 B5.00000 F91.672783
N200 G1 X1449.48884 Y7.38801 Z157.60864 A137.18873 B5.00000 F91.672783
N210 G1 X1449.53051 Y7.38801 Z157.60864 A167.18873 B5.00000 F91.672783
N220 G1 X1449.57217 Y7.38801 Z157.60864 A197.18873 B5.00000 F91.672783
N230 G1 X1449.61384 Y7.38801 Z157.60864 A227.18873 B5.00000 F91.672783
N240 G1 X1449.65551 Y7.38801 Z157.60864 A257.18873 B5.00000 F91.672783
N250 G1 X1449.69717 Y7.38801 Z157.60864 A287.18873 B5.00000 F91.672783
N260 G94
(Retract along the tool axis)
N270 G1 X1450.13295 Y7.38801 Z162.58961 F300
N280 G1 X1453.01702 Y7.38801 Z195.55465 F5000
N290 M9
N300 G53 G0 Z630.00000
(Unwind of A: back to its first position, over all turns.)
N310 G0 A-72.81127
N320 M5
N330 M30
%
