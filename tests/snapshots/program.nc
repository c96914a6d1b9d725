%
O0001
(Size           115 lines,       5281 bytes)
(==============================================================================)
(CYL_ROOT  for Fanuc, G43.4, by bladewright 0.1.0)
(Part     cylinder  file cylinder.obj)
(Hash     0123abcd)
(Job      made up for a test)
(Machine  demo_table_head)
(LIMITS   of X Y Z A B are ASSUMED, not measured: times below are estimates)
(Tool     T1  ball end, R 5.0000 mm, half angle of taper 3.000 deg, shank R 8.000 mm, stick-out 70.000 mm from the ball)
(centre)
(Holder 1 R 20.000 mm, 40.000 mm long)
(Holder 2 R 30.000 mm, 25.000 mm long)
(Path     helix of 1 turns, 13 locations, 157.1 mm, blade axis x 20.000 to 20.500 mm)
(Lead-in  arc of radius 4.000 mm, 90.0 deg, tangential to the path)
(Lead-out arc of radius 4.000 mm, 90.0 deg, tangential to the path)
(Scallop  0.01 mm asked for, chord tolerance 100 mm)
(Time     7.9 s of cutting)
(Cycle    22.0 s: approach 7.2, lead-in 0.3, cutting 7.9, lead-out 0.3, retract 2.4, unwinding 3.9)
(         [without tool change and the way to over the part])
(Verified before posting:)
(  ok     gouge: 0.000500 mm, limit 0.003000 mm)
(  ok     scallop: 0.010100 mm, limit 0.010500 mm)
(==============================================================================)
(X Y Z    tool TIP of the ball in the blade frame, mm: x along the blade axis from root to tip.)
(         Offset H1: from the gauge line to the TIP, planned as 140.0000 mm.)
(G54      origin of the blade frame at A=0: machine X 1400.0000 Y 0.0000 Z 0.0000, turned about X by 0.0000 deg.)
(A        degrees, growing over all turns: A must be a linear axis to the control [ROT type B], or one that does not)
(roll over.)
(F        G94, mm/min of the TIP over the part; degrees/min on lines on which it stands still.)
(Relies on parameters 19696#5 WKP=0: X Y Z turn with the table; 19696#6 RFC=1: F holds where the tip stands still;)
(         increment system IS-C: 0.0001 mm and deg. IS-B rounds each word to 0.001, nothing adds up.)
(G43.4    fixes X Y Z to the table as it stands then: it comes on with the table at 0, which turns in step by step)
(afterwards.)
N1 G17 G21 G40 G49 G80 G90 G94
G53 G0 Z630.000
T1 M6
S6000 M3
G0 A0.0000 B5.0000
G53 G0 X1452.151 Y8.865
G54
(AI contour control, an option of the control: without it leave this out with post.look_ahead = false)
G5.1 Q1
(Tool-centre-point control, the table at 0)
G43.4 H1 X22.5181 Y8.8645 Z481.2938
(The table turns, then down to the safe position and along the tool axis)
G0 X22.5181 Y-182.4839 Z445.4458 A23.3324 B5.0000
G0 X22.5181 Y-343.9862 Z336.7429 A46.6648 B5.0000
G0 X22.5181 Y-449.2279 Z172.9641 A69.9972 B5.0000
G0 X22.5181 Y-480.9962 Z-19.1038 A93.3296 B5.0000
G0 X22.5181 Y-434.0952 Z-208.0472 A116.6620 B5.0000
G0 X22.5181 Y-316.1959 Z-362.9634 A139.9944 B5.0000
G0 X22.5181 Y-146.5812 Z-458.5153 A163.3268 B5.0000
G0 X22.5181 Y47.0076 Z-479.0747 A186.6592 B5.0000
G0 X22.5181 Y232.9081 Z-421.2792 A209.9916 B5.0000
G0 X22.5181 Y380.7153 Z-294.5814 A233.3240 B5.0000
G0 X22.5181 Y466.2547 Z-119.7034 A256.6564 B5.0000
G0 X22.5181 Y475.5358 Z74.7527 A279.9888 B5.0000
G0 X22.5181 Y57.5989 Z1.1436 A279.9888 B5.0000
M8
G1 X19.9886 Y29.1246 Z-3.8714 F5000
G1 X19.5528 Y24.2191 Z-4.7354 F300
(Cutting)
(Lead-in)
N2 G1 X19.5529 Y23.6969 Z-4.7220 A280.0388 F1197.188
G1 X19.5531 Y23.1831 Z-4.6490 A280.1888 F1189.369
G1 X19.5536 Y22.6864 Z-4.5180 A280.4388 F1177.279
G1 X19.5542 Y22.2157 Z-4.3315 A280.7888 F1160.357
G1 X19.5550 Y21.7791 Z-4.0931 A281.2388 F1140.067
G1 X19.5560 Y21.3846 Z-3.8076 A281.7888 F1116.057
G1 X19.5571 Y21.0392 Z-3.4805 A282.4388 F1090.239
G1 X19.5584 Y20.7493 Z-3.1185 A283.1888 F1062.895
G1 X19.5598 Y20.5206 Z-2.7286 A284.0387 F1035.968
G1 X19.5612 Y20.3575 Z-2.3187 A284.9887 F1011.063
G1 X19.5627 Y20.2636 Z-1.8969 A286.0387 F990.365
G1 X19.5642 Y20.2415 Z-1.4720 A287.1887 F975.121
(Turn 1 of 1)
N3 G1 X19.6059 Y18.2656 Z8.8460 A317.1887 F963.075
G1 X19.6476 Y11.3955 Z16.7937 A347.1887 F963.070
G1 X19.6892 Y1.4720 Z20.2415 A377.1887 F963.066
G1 X19.7309 Y-8.8460 Z18.2656 A407.1887 F963.075
G1 X19.7726 Y-16.7937 Z11.3955 A437.1887 F963.070
G1 X19.8142 Y-20.2415 Z1.4720 A467.1887 F963.066
G1 X19.8559 Y-18.2656 Z-8.8460 A497.1887 F963.075
G1 X19.8976 Y-11.3955 Z-16.7937 A527.1887 F963.070
G1 X19.9392 Y-1.4720 Z-20.2415 A557.1887 F963.066
G1 X19.9809 Y8.8460 Z-18.2656 A587.1887 F963.075
G1 X20.0226 Y16.7937 Z-11.3955 A617.1887 F963.070
G1 X20.0642 Y20.2415 Z-1.4720 A647.1887 F963.066
(Lead-out)
N4 G1 X20.0658 Y20.3227 Z-1.0464 A648.3387 F993.004
G1 X20.0673 Y20.4705 Z-0.6231 A649.3887 F1027.574
G1 X20.0687 Y20.6823 Z-0.2109 A650.3387 F1062.110
G1 X20.0700 Y20.9547 Z0.1817 A651.1887 F1095.146
G1 X20.0713 Y21.2829 Z0.5467 A651.9387 F1124.964
G1 X20.0724 Y21.6616 Z0.8767 A652.5887 F1151.209
G1 X20.0734 Y22.0843 Z1.1650 A653.1387 F1172.632
G1 X20.0742 Y22.5438 Z1.4058 A653.5887 F1188.940
G1 X20.0748 Y23.0324 Z1.5944 A653.9387 F1200.316
G1 X20.0753 Y23.5418 Z1.7270 A654.1887 F1206.364
G1 X20.0755 Y24.0633 Z1.8009 A654.3387 F1207.131
G1 X20.0756 Y24.5881 Z1.8146 A654.3887 F1203.163
(Retract along the tool axis)
N5 G1 X20.5114 Y29.1246 Z3.8714 F300
G1 X23.0272 Y55.3140 Z15.7453 F5000
M9
G49
G5.1 Q0
G53 G0 Z630.000
M5
(Unwind of A: back to its first position, over all turns.)
G0 A0.0000 B5.0000
M30
%
