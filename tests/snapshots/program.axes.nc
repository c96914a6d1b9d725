%
O0001
(Size           101 lines,       4644 bytes)
(==============================================================================)
(CYL_ROOT  for Fanuc, positions of axes, by bladewright 0.1.0)
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
(Cycle    15.6 s: approach 2.4, lead-in 0.3, cutting 7.9, lead-out 0.3, retract 2.4, unwinding 2.4)
(         [without tool change and the way to over the part])
(Verified before posting:)
(  ok     gouge: 0.000500 mm, limit 0.003000 mm)
(  ok     scallop: 0.010100 mm, limit 0.010500 mm)
(==============================================================================)
(X Y Z    positions of the machine's axes, mm: the tool's length, the head's pivot and the place of the part)
(         are in them. No length offset [G49]; G54 must be zero.)
(         The tool must stand out 140.0000 mm from the gauge line to its TIP; any other length cuts elsewhere.)
(A        degrees, growing over all turns: A must be a linear axis to the control [ROT type B], or one that does not)
(roll over.)
(F        G94, along all axes of a line together, a degree counted as a millimetre, as this control does without G43.4.)
(Relies on A as an axis, no spindle, and on S and M3 for the spindle that holds the tool; a lathe that wants its own M)
(codes)
(         for that has them before this program. On a lathe: G code system B or C [G90 G94].)
(         Increment system IS-C: 0.0001 mm and deg. IS-B rounds each word to 0.001, nothing adds up.)
N1 G17 G21 G40 G49 G80 G90 G94
G54
G53 G0 Z630.0000
T1 M6
G49
S6000 M3
(AI contour control, an option of the control: without it leave this out with post.look_ahead = false)
G5.1 Q1
(Approach along the tool axis)
G0 A279.9888 B5.0000
G0 X1452.1511 Y8.8645
G0 X1452.1511 Y8.8645 Z195.6304
M8
G1 X1449.6216 Y8.8645 Z166.7178 F5000
G1 X1449.1858 Y8.8645 Z161.7368 F300
(Cutting)
(Lead-in)
N2 G1 X1449.1858 Y8.7804 Z161.2172 A280.0388 F1211.763
G1 X1449.1861 Y8.6766 Z160.7013 A280.1888 F1254.089
G1 X1449.1865 Y8.5537 Z160.1986 A280.4388 F1317.179
G1 X1449.1872 Y8.4134 Z159.7184 A280.7888 F1399.288
G1 X1449.1880 Y8.2593 Z159.2699 A281.2388 F1498.303
G1 X1449.1890 Y8.0962 Z158.8618 A281.7888 F1613.502
G1 X1449.1901 Y7.9306 Z158.5018 A282.4388 F1744.691
G1 X1449.1913 Y7.7704 Z158.1967 A283.1888 F1891.631
G1 X1449.1927 Y7.6249 Z157.9520 A284.0387 F2054.202
G1 X1449.1941 Y7.5048 Z157.7714 A284.9887 F2233.263
G1 X1449.1956 Y7.4217 Z157.6570 A286.0387 F2428.146
G1 X1449.1972 Y7.3880 Z157.6086 A287.1887 F2639.072
(Turn 1 of 1)
N3 G1 X1449.2388 Y7.3880 Z157.6086 A317.1887 F2750.186
G1 X1449.2805 Y7.3880 Z157.6086 A347.1887 F2750.186
G1 X1449.3222 Y7.3880 Z157.6086 A377.1887 F2750.186
G1 X1449.3638 Y7.3880 Z157.6086 A407.1887 F2750.186
G1 X1449.4055 Y7.3880 Z157.6086 A437.1887 F2750.186
G1 X1449.4472 Y7.3880 Z157.6086 A467.1887 F2750.186
G1 X1449.4888 Y7.3880 Z157.6086 A497.1887 F2750.186
G1 X1449.5305 Y7.3880 Z157.6086 A527.1887 F2750.186
G1 X1449.5722 Y7.3880 Z157.6086 A557.1887 F2750.186
G1 X1449.6138 Y7.3880 Z157.6086 A587.1887 F2750.186
G1 X1449.6555 Y7.3880 Z157.6086 A617.1887 F2750.186
G1 X1449.6972 Y7.3880 Z157.6086 A647.1887 F2750.186
(Lead-out)
N4 G1 X1449.6987 Y7.3875 Z157.6675 A648.3387 F2639.063
G1 X1449.7002 Y7.3835 Z157.8089 A649.3887 F2428.165
G1 X1449.7016 Y7.3863 Z158.0258 A650.3387 F2233.278
G1 X1449.7030 Y7.4045 Z158.3099 A651.1887 F2054.414
G1 X1449.7043 Y7.4445 Z158.6522 A651.9387 F1891.658
G1 X1449.7054 Y7.5111 Z159.0428 A652.5887 F1744.662
G1 X1449.7064 Y7.6069 Z159.4717 A653.1387 F1613.478
G1 X1449.7072 Y7.7330 Z159.9289 A653.5887 F1498.363
G1 X1449.7078 Y7.8883 Z160.4044 A653.9387 F1399.179
G1 X1449.7082 Y8.0707 Z160.8887 A654.1887 F1317.188
G1 X1449.7085 Y8.2764 Z161.3731 A654.3387 F1254.149
G1 X1449.7086 Y8.5003 Z161.8495 A654.3887 F1211.831
(Retract along the tool axis)
N5 G1 X1450.1443 Y8.5003 Z166.8304 F300
G1 X1452.6601 Y8.5003 Z195.5859 F5000
M9
G5.1 Q0
G53 G0 Z630.0000
M5
(Unwind of A: back to its first position, over all turns.)
G0 A279.9888
M30
%
