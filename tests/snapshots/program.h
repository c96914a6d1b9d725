0 BEGIN PGM CYL_ROOT MM
1 ; ==============================================================================
2 ; CYL_ROOT  for Heidenhain TNC, by bladewright 0.1.0
3 ; Part     cylinder  file cylinder.obj
4 ; Hash     0123abcd
5 ; Job      made up for a test
6 ; Machine  demo_table_head
7 ; Tool     T1  ball end, R 5.0000 mm, half angle of taper 3.000 deg, shank R 8.000 mm, stick-out 70.000 mm from
8 ; the ball centre
9 ; Holder 1 R 20.000 mm, 40.000 mm long
10 ; Holder 2 R 30.000 mm, 25.000 mm long
11 ; Path     helix of 1 turns, 13 locations, 157.1 mm, blade axis x 20.000 to 20.500 mm
12 ; Lead-in  arc of radius 4.000 mm, 90.0 deg, tangential to the path
13 ; Lead-out arc of radius 4.000 mm, 90.0 deg, tangential to the path
14 ; Scallop  0.01 mm asked for, chord tolerance 100 mm
15 ; Time     7.9 s of cutting
16 ; Verified before posting:
17 ;   ok     gouge: 0.000500 mm, limit 0.003000 mm
18 ;   ok     scallop: 0.010100 mm, limit 0.010500 mm
19 ; ==============================================================================
20 ; X Y Z    ball CENTRE in the blade frame, mm: x along the blade axis from root to tip. TCPM takes the length of
21 ; a ball
22 ;          cutter to its centre: L of the tool from the gauge line to the CENTRE, planned as 135.0000 mm.
23 ; Preset   origin of the blade frame at A=0: machine X +1400.0000 Y +0.0000 Z +0.0000, turned about X by +0.0000
24 ; deg.
25 ; A        within one turn; M126 takes the shorter way, which is the planned one: no line turns by more than
26 ; half a turn.
27 ; F        mm/min of the ball centre.
28 M129
29 TOOL CALL 1 Z S6000
30 M3
31 M126
32 L Z+630.000 R0 FMAX M91
33 L A+279.9888 B+5.0000 R0 FMAX
34 L X+1452.151 Y+8.865 R0 FMAX M91
35 CYCL DEF 32.0 TOLERANCE
36 CYCL DEF 32.1 T0.00300
37 CYCL DEF 32.2 HSC-MODE:0 TA0.0500
38 FUNCTION TCPM F TCP AXIS POS PATHCTRL AXIS
39 ; Down to the safe position, then along the tool axis
40 L X+22.9539 Y+62.5044 Z+2.0076 R0 FMAX
41 L X+20.4244 Y+34.0300 Z-3.0074 R0 F5000 M8
42 L X+19.9886 Y+29.1246 Z-3.8714 R0 F300
43 ; Cutting
44 ; Lead-in
45 L X+19.9887 Y+28.6016 Z-3.8537 A+280.0388 F1199.1434
46 L X+19.9889 Y+28.0855 Z-3.7679 A+280.1888 F1199.1434
47 L X+19.9894 Y+27.5850 Z-3.6155 A+280.4388 F1199.1434
48 L X+19.9900 Y+27.1086 Z-3.3991 A+280.7888 F1199.1434
49 L X+19.9908 Y+26.6646 Z-3.1223 A+281.2388 F1199.1434
50 L X+19.9918 Y+26.2605 Z-2.7899 A+281.7888 F1199.1434
51 L X+19.9929 Y+25.9032 Z-2.4077 A+282.4388 F1199.1434
52 L X+19.9942 Y+25.5989 Z-1.9820 A+283.1888 F1199.1434
53 L X+19.9955 Y+25.3528 Z-1.5203 A+284.0387 F1199.1434
54 L X+19.9970 Y+25.1690 Z-1.0304 A+284.9887 F1199.1434
55 L X+19.9985 Y+25.0507 Z-0.5208 A+286.0387 F1199.1434
56 L X+20.0000 Y+25.0000 Z+0.0000 A+287.1887 F1199.1434
57 ; Turn 1 of 1
58 L X+20.0417 Y+21.6506 Z+12.5000 A+317.1887 F1186.3393
59 L X+20.0833 Y+12.5000 Z+21.6506 A+347.1887 F1186.3393
60 L X+20.1250 Y+0.0000 Z+25.0000 A+17.1887 F1186.3393
61 L X+20.1667 Y-12.5000 Z+21.6506 A+47.1887 F1186.3393
62 L X+20.2083 Y-21.6506 Z+12.5000 A+77.1887 F1186.3393
63 L X+20.2500 Y-25.0000 Z+0.0000 A+107.1887 F1186.3393
64 L X+20.2917 Y-21.6506 Z-12.5000 A+137.1887 F1186.3393
65 L X+20.3333 Y-12.5000 Z-21.6506 A+167.1887 F1186.3393
66 L X+20.3750 Y+0.0000 Z-25.0000 A+197.1887 F1186.3393
67 L X+20.4167 Y+12.5000 Z-21.6506 A+227.1887 F1186.3393
68 L X+20.4583 Y+21.6506 Z-12.5000 A+257.1887 F1186.3393
69 L X+20.5000 Y+25.0000 Z+0.0000 A+287.1887 F1186.3393
70 ; Lead-out
71 L X+20.5015 Y+25.0507 Z+0.5208 A+288.3387 F1199.1434
72 L X+20.5030 Y+25.1690 Z+1.0304 A+289.3887 F1199.1434
73 L X+20.5045 Y+25.3528 Z+1.5203 A+290.3387 F1199.1434
74 L X+20.5058 Y+25.5989 Z+1.9820 A+291.1887 F1199.1434
75 L X+20.5071 Y+25.9032 Z+2.4077 A+291.9387 F1199.1434
76 L X+20.5082 Y+26.2605 Z+2.7899 A+292.5887 F1199.1434
77 L X+20.5092 Y+26.6646 Z+3.1223 A+293.1387 F1199.1434
78 L X+20.5100 Y+27.1086 Z+3.3991 A+293.5887 F1199.1434
79 L X+20.5106 Y+27.5850 Z+3.6155 A+293.9387 F1199.1434
80 L X+20.5111 Y+28.0855 Z+3.7679 A+294.1887 F1199.1434
81 L X+20.5113 Y+28.6016 Z+3.8537 A+294.3387 F1199.1434
82 L X+20.5114 Y+29.1246 Z+3.8714 A+294.3887 F1199.1434
83 ; Retract along the tool axis
84 L X+20.9472 Y+33.6611 Z+5.9282 F300
85 L X+23.4629 Y+59.8505 Z+17.8020 F5000 M9
86 FUNCTION RESET TCPM
87 CYCL DEF 32.0 TOLERANCE
88 CYCL DEF 32.1
89 L Z+630.000 R0 FMAX M91
90 ; A back to its first position: less than a turn
91 L A+279.9888 R0 FMAX
92 M127
93 M5
94 M30
95 END PGM CYL_ROOT MM
