0 BEGIN PGM CYL_ROOT MM
1 ; ==============================================================================
2 ; CYL_ROOT  for Heidenhain TNC, LN, by bladewright 0.1.0
3 ; Part     cylinder  file cylinder.obj
4 ; Hash     0123abcd
5 ; Job      made up for a test
6 ; Machine  demo_table_head
7 ; Tool     T1  ball end, R 5.0000 mm, half angle of taper 3.000 deg, shank R 8.000 mm, stick-out 70.000 mm from
8 ; the ball centre
9 ; Holder 1 R 20.000 mm, 40.000 mm long
10 ; Holder 2 R 30.000 mm, 25.000 mm long
11 ; Path     helix of 1 turns, 13 locations, 157.1 mm, blade axis x 20.000 to 20.500 mm
12 ; Scallop  0.01 mm asked for, chord tolerance 100 mm
13 ; Time     7.9 s of cutting
14 ; Verified before posting:
15 ;   ok     gouge: 0.000500 mm, limit 0.003000 mm
16 ;   ok     scallop: 0.010100 mm, limit 0.010500 mm
17 ; ==============================================================================
18 ; X Y Z    ball CENTRE in the blade frame, mm: x along the blade axis from root to tip. TCPM takes the length of
19 ; a ball
20 ;          cutter to its centre: L of the tool from the gauge line to the CENTRE, planned as 135.0000 mm.
21 ; Preset   origin of the blade frame at A=0: machine X +1400.0000 Y +0.0000 Z +0.0000, turned about X by +0.0000
22 ; deg.
23 ; TX TY TZ tool axis from tip to spindle in the blade frame. M126 takes the shorter way, which is the planned
24 ; one.
25 ; F        mm/min of the ball centre.
26 M129
27 TOOL CALL 1 Z S6000
28 M3
29 M126
30 L Z+630.000 R0 FMAX M91
31 L A-72.8113 B+5.0000 R0 FMAX
32 L X+1452.521 Y+7.388 R0 FMAX M91
33 CYCL DEF 32.0 TOLERANCE
34 CYCL DEF 32.1 T0.00300
35 CYCL DEF 32.2 HSC-MODE:0 TA0.0500
36 FUNCTION TCPM F TCP AXIS POS PATHCTRL AXIS
37 ; Down to the safe position, then along the tool axis
38 L X+23.3236 Y+61.2927 Z+11.2266 R0 FMAX
39 L X+20.4358 Y+29.7585 Z+1.4720 R0 F5000 M8
40 L X+20.0000 Y+25.0000 Z+0.0000 R0 F300
41 ; Cutting
42 ; Turn 1 of 1
43 LN X+20.0417 Y+21.6506 Z+12.5000 TX+0.08715574 TY+0.67699954 TZ+0.73080470 F1186.3393
44 LN X+20.0833 Y+12.5000 Z+21.6506 TX+0.08715574 TY+0.22089645 TZ+0.97139520 F1186.3393
45 LN X+20.1250 Y+0.0000 Z+25.0000 TX+0.08715574 TY-0.29439566 TZ+0.95170115 F1186.3393
46 LN X+20.1667 Y-12.5000 Z+21.6506 TX+0.08715574 TY-0.73080470 TZ+0.67699954 F1186.3393
47 LN X+20.2083 Y-21.6506 Z+12.5000 TX+0.08715574 TY-0.97139520 TZ+0.22089645 F1186.3393
48 LN X+20.2500 Y-25.0000 Z+0.0000 TX+0.08715574 TY-0.95170115 TZ-0.29439566 F1186.3393
49 LN X+20.2917 Y-21.6506 Z-12.5000 TX+0.08715574 TY-0.67699954 TZ-0.73080470 F1186.3393
50 LN X+20.3333 Y-12.5000 Z-21.6506 TX+0.08715574 TY-0.22089645 TZ-0.97139520 F1186.3393
51 LN X+20.3750 Y+0.0000 Z-25.0000 TX+0.08715574 TY+0.29439566 TZ-0.95170115 F1186.3393
52 LN X+20.4167 Y+12.5000 Z-21.6506 TX+0.08715574 TY+0.73080470 TZ-0.67699954 F1186.3393
53 LN X+20.4583 Y+21.6506 Z-12.5000 TX+0.08715574 TY+0.97139520 TZ-0.22089645 F1186.3393
54 LN X+20.5000 Y+25.0000 Z+0.0000 TX+0.08715574 TY+0.95170115 TZ+0.29439566 F1186.3393
55 ; Retract along the tool axis
56 L X+20.9358 Y+29.7585 Z+1.4720 F300
57 L X+23.8198 Y+61.2512 Z+11.2138 F5000 M9
58 FUNCTION RESET TCPM
59 CYCL DEF 32.0 TOLERANCE
60 CYCL DEF 32.1
61 L Z+630.000 R0 FMAX M91
62 ; A back to its first position: less than a turn
63 L A-72.8113 R0 FMAX
64 M127
65 M5
66 M30
67 END PGM CYL_ROOT MM
