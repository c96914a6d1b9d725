0 BEGIN PGM CYL_ROOT MM
1 ; Size           101 lines,       4817 bytes
2 ; ==============================================================================
3 ; CYL_ROOT  for Heidenhain TNC, by bladewright 0.1.0
4 ; CAUTION  L of tool T1 is to the ball CENTRE: 135.0000 mm. A presetter measures the tip, 5.0000 mm more.
5 ; Part     cylinder  file cylinder.obj
6 ; Hash     0123abcd
7 ; Job      made up for a test
8 ; Machine  demo_table_head
9 ; LIMITS   of X Y Z A B are ASSUMED, not measured: times below are estimates
10 ; Tool     T1  ball end, R 5.0000 mm, half angle of taper 3.000 deg, shank R 8.000 mm, stick-out 70.000 mm from
11 ; the ball centre
12 ; Holder 1 R 20.000 mm, 40.000 mm long
13 ; Holder 2 R 30.000 mm, 25.000 mm long
14 ; Path     helix of 1 turns, 13 locations, 157.1 mm, blade axis x 20.000 to 20.500 mm
15 ; Lead-in  arc of radius 4.000 mm, 90.0 deg, tangential to the path
16 ; Lead-out arc of radius 4.000 mm, 90.0 deg, tangential to the path
17 ; Scallop  0.01 mm asked for, chord tolerance 100 mm
18 ; Time     7.9 s of cutting
19 ; Cycle    13.6 s: approach 2.4, lead-in 0.3, cutting 7.9, lead-out 0.3, retract 2.4, unwinding 0.3
20 ;          [without tool change and the way to over the part]
21 ; Verified before posting:
22 ;   ok     gouge: 0.000500 mm, limit 0.003000 mm
23 ;   ok     scallop: 0.010100 mm, limit 0.010500 mm
24 ; ==============================================================================
25 ; X Y Z    ball CENTRE in the blade frame, mm: x along the blade axis from root to tip. TCPM takes the length of
26 ; a ball
27 ;          cutter to its centre: L of the tool from the gauge line to the CENTRE, planned as 135.0000 mm.
28 ; Preset   origin of the blade frame at A=0: machine X +1400.0000 Y +0.0000 Z +0.0000, turned about X by +0.0000
29 ; deg.
30 ; A        within one turn; M126 takes the shorter way, which is the planned one: no line turns by more than
31 ; half a turn.
32 ; F        mm/min of the ball centre.
33 M129
34 TOOL CALL 1 Z S6000
35 M3
36 M126
37 L Z+630.000 R0 FMAX M91
38 L A+279.9888 B+5.0000 R0 FMAX
39 L X+1452.151 Y+8.865 R0 FMAX M91
40 CYCL DEF 32.0 TOLERANCE
41 CYCL DEF 32.1 T0.00300
42 CYCL DEF 32.2 HSC-MODE:0 TA0.0500
43 FUNCTION TCPM F TCP AXIS POS PATHCTRL AXIS
44 ; Down to the safe position, then along the tool axis
45 L X+22.9539 Y+62.5044 Z+2.0076 R0 FMAX
46 L X+20.4244 Y+34.0300 Z-3.0074 R0 F5000 M8
47 L X+19.9886 Y+29.1246 Z-3.8714 R0 F300
48 ; Cutting
49 ; Lead-in
50 L X+19.9887 Y+28.6016 Z-3.8537 A+280.0388 F1199.314
51 L X+19.9889 Y+28.0855 Z-3.7679 A+280.1888 F1199.048
52 L X+19.9894 Y+27.5850 Z-3.6155 A+280.4388 F1199.060
53 L X+19.9900 Y+27.1086 Z-3.3991 A+280.7888 F1199.191
54 L X+19.9908 Y+26.6646 Z-3.1223 A+281.2388 F1199.123
55 L X+19.9918 Y+26.2605 Z-2.7899 A+281.7888 F1199.194
56 L X+19.9929 Y+25.9032 Z-2.4077 A+282.4388 F1199.093
57 L X+19.9942 Y+25.5989 Z-1.9820 A+283.1888 F1199.267
58 L X+19.9955 Y+25.3528 Z-1.5203 A+284.0387 F1199.076
59 L X+19.9970 Y+25.1690 Z-1.0304 A+284.9887 F1199.192
60 L X+19.9985 Y+25.0507 Z-0.5208 A+286.0387 F1198.979
61 L X+20.0000 Y+25.0000 Z+0.0000 A+287.1887 F1199.233
62 ; Turn 1 of 1
63 L X+20.0417 Y+21.6506 Z+12.5000 A+317.1887 F1186.340
64 L X+20.0833 Y+12.5000 Z+21.6506 A+347.1887 F1186.335
65 L X+20.1250 Y+0.0000 Z+25.0000 A+17.1887 F1186.340
66 L X+20.1667 Y-12.5000 Z+21.6506 A+47.1887 F1186.340
67 L X+20.2083 Y-21.6506 Z+12.5000 A+77.1887 F1186.335
68 L X+20.2500 Y-25.0000 Z+0.0000 A+107.1887 F1186.340
69 L X+20.2917 Y-21.6506 Z-12.5000 A+137.1887 F1186.340
70 L X+20.3333 Y-12.5000 Z-21.6506 A+167.1887 F1186.335
71 L X+20.3750 Y+0.0000 Z-25.0000 A+197.1887 F1186.340
72 L X+20.4167 Y+12.5000 Z-21.6506 A+227.1887 F1186.340
73 L X+20.4583 Y+21.6506 Z-12.5000 A+257.1887 F1186.335
74 L X+20.5000 Y+25.0000 Z+0.0000 A+287.1887 F1186.340
75 ; Lead-out
76 L X+20.5015 Y+25.0507 Z+0.5208 A+288.3387 F1199.233
77 L X+20.5030 Y+25.1690 Z+1.0304 A+289.3887 F1198.979
78 L X+20.5045 Y+25.3528 Z+1.5203 A+290.3387 F1199.192
79 L X+20.5058 Y+25.5989 Z+1.9820 A+291.1887 F1199.076
80 L X+20.5071 Y+25.9032 Z+2.4077 A+291.9387 F1199.267
81 L X+20.5082 Y+26.2605 Z+2.7899 A+292.5887 F1199.093
82 L X+20.5092 Y+26.6646 Z+3.1223 A+293.1387 F1199.194
83 L X+20.5100 Y+27.1086 Z+3.3991 A+293.5887 F1199.123
84 L X+20.5106 Y+27.5850 Z+3.6155 A+293.9387 F1199.191
85 L X+20.5111 Y+28.0855 Z+3.7679 A+294.1887 F1199.060
86 L X+20.5113 Y+28.6016 Z+3.8537 A+294.3387 F1199.048
87 L X+20.5114 Y+29.1246 Z+3.8714 A+294.3887 F1199.314
88 ; Retract along the tool axis
89 L X+20.9472 Y+33.6611 Z+5.9282 F300
90 L X+23.4629 Y+59.8505 Z+17.8020 F5000 M9
91 FUNCTION RESET TCPM
92 CYCL DEF 32.0 TOLERANCE
93 CYCL DEF 32.1
94 L Z+630.000 R0 FMAX M91
95 M5
96 ; A back to its first position: less than a turn
97 L A+279.9888 R0 FMAX
98 M127
99 M30
100 END PGM CYL_ROOT MM
