$pairs0 << EOD
11939 4286 -0.1875
342 185 0.8125
0.5 0.5 1.8125
43 0.5 2.8125
911 0.5 3.8125
630 0.5 4.8125
0.5 0.5 5.8125
0.5 0.5 6.8125
12527 12056 7.8125
12009 11489 8.8125
2075 1179 9.8125
3601 2533 10.8125
1117 482 11.8125
11317 2719 12.8125
1183 1168 13.8125
656 0.5 14.8125
418 0.5 15.8125
298 20 16.8125
293 5 17.8125
131 0.5 18.8125
131 0.5 19.8125
131 0.5 20.8125
129 0.5 21.8125
0.5 0.5 22.8125
7 0.5 23.8125
738 0.5 24.8125
5713 2156 25.8125
129 0.5 26.8125
132 0.5 27.8125
4928 3492 28.8125
1805 814 29.8125
EOD
$edges0 << EOD
1.52928 1.02303 -0.1875
1.09024 1.00604 0.8125
1.01368 1 1.8125
1.03165 1 2.8125
1.06205 1 3.8125
1.07449 1 4.8125
1.00002 1 5.8125
1.00363 1 6.8125
1.21306 1.04056 7.8125
1.2137 1.03973 8.8125
1.28452 1.03915 9.8125
1.72075 1.03988 10.8125
1.06906 1.04814 11.8125
1.45161 1.0273 12.8125
1.07973 1.03558 13.8125
2.15232 1.55869 14.8125
2.75412 1.55969 15.8125
5.5348 1.55845 16.8125
5.88108 1.5561 17.8125
1.00561 1 18.8125
1.00499 1 19.8125
1.44112 1.23542 20.8125
1.36932 1.19256 21.8125
1.01278 1.00645 22.8125
1.00372 1.00283 23.8125
1.07631 1.03554 24.8125
1.59664 1.02149 25.8125
1.04686 1 26.8125
1.05656 1 27.8125
1.6078 1.35174 28.8125
3.96676 1.43509 29.8125
EOD
$pairs1 << EOD
11036 4014 -0.0625
1097 454 0.9375
1146 0.5 1.9375
1778 0.5 2.9375
8242 0.5 3.9375
15087 756 4.9375
0.5 0.5 5.9375
0.5 0.5 6.9375
11973 9339 7.9375
11911 11220 8.9375
1612 992 9.9375
2769 2386 10.9375
534 517 11.9375
18279 10026 12.9375
1365 530 13.9375
827 0.5 14.9375
411 0.5 15.9375
257 11 16.9375
333 0.5 17.9375
349 0.5 18.9375
131 0.5 19.9375
319 30 20.9375
129 0.5 21.9375
0.5 0.5 22.9375
8 0.5 23.9375
791 0.5 24.9375
5769 2171 25.9375
1363 0.5 26.9375
979 0.5 27.9375
3773 2073 28.9375
1400 261 29.9375
EOD
$edges1 << EOD
1.55218 1.15075 -0.0625
1.39662 1.08971 0.9375
1.32579 1.03961 1.9375
1.54141 1.09312 2.9375
1.4185 1.25654 3.9375
1.50794 1.1689 4.9375
1.00002 1 5.9375
1.00363 1 6.9375
1.58673 1.33878 7.9375
1.43124 1.26504 8.9375
1.54059 1.2602 9.9375
1.71916 1.35301 10.9375
1.39074 1.18936 11.9375
1.8402 1.35293 12.9375
1.50451 1.38412 13.9375
2.4772 1.55804 14.9375
4.02478 1.55898 15.9375
5.53768 1.55787 16.9375
5.88529 1.55878 17.9375
1.31443 1.00138 18.9375
1.00499 1 19.9375
1.48733 1.24915 20.9375
1.36932 1.19256 21.9375
1.04432 1.00645 22.9375
1.25261 1.00503 23.9375
1.53364 1.03585 24.9375
1.65327 1.22913 25.9375
1.65386 1.03151 26.9375
1.38672 1.03961 27.9375
2.26559 1.80352 28.9375
5.46623 1.43509 29.9375
EOD
$pairs2 << EOD
EOD
$edges2 << EOD
EOD
$pairs3 << EOD
0.5 0.5 0.1875
0.5 0.5 1.1875
0.5 0.5 2.1875
0.5 0.5 3.1875
0.5 0.5 4.1875
0.5 0.5 5.1875
0.5 0.5 6.1875
0.5 0.5 7.1875
0.5 0.5 8.1875
0.5 0.5 9.1875
0.5 0.5 10.1875
0.5 0.5 11.1875
0.5 0.5 12.1875
0.5 0.5 13.1875
0.5 0.5 14.1875
0.5 0.5 15.1875
0.5 0.5 16.1875
0.5 0.5 17.1875
0.5 0.5 18.1875
0.5 0.5 19.1875
0.5 0.5 20.1875
0.5 0.5 21.1875
0.5 0.5 22.1875
0.5 0.5 23.1875
0.5 0.5 24.1875
740 0.5 25.1875
2042 481 26.1875
382 0.5 27.1875
309 0.5 28.1875
0.5 0.5 29.1875
0.5 0.5 30.1875
EOD
$edges3 << EOD
1.16752 1.00367 0.1875
1.16026 1.01872 1.1875
1.00679 1.0002 2.1875
1.0078 1.00086 3.1875
1.07138 1.00123 4.1875
1.04766 1.0042 5.1875
1.00371 1.00006 6.1875
1.01181 1.00098 7.1875
1.14546 1.03927 8.1875
1.28399 1.0355 9.1875
1.08126 1.0573 10.1875
1.59895 1.04628 11.1875
1.06906 1.04954 12.1875
1.80034 1.52522 13.1875
1.09984 1.09945 14.1875
4.18493 3.26143 15.1875
6.1791 3.94086 16.1875
15.3566 4.01926 17.1875
16.6224 3.04771 18.1875
1.0483 1.00121 19.1875
1.03796 1.00272 20.1875
1.44112 1.34564 21.1875
1.39801 1.27489 22.1875
1.04952 1.01844 23.1875
1.1635 1.00513 24.1875
1.69331 1.0345 25.1875
1.2957 1.01342 26.1875
1.07217 1.00027 27.1875
1.06393 1.00029 28.1875
4.92467 1.35408 29.1875
4.27223 1.43509 30.1875
EOD
set yrange [30.5:-0.5]
set grid
set logscale x
set key outside top center horizontal
set ytics ('folddrop' 0, 'ribbon' 1, 'stack 2' 2, 'stack 3' 3, 'stack 5' 4, 'stack 10' 5, 'stack 2 of cloths' 6, 'stack 5 of cloths' 7, 'stacked' 8, 'stacked of cloths' 9, 'drape' 10, 'drape 16k' 11, 'gathered' 12, 'crumple' 13, 'twist' 14, 'yank 5' 15, 'yank 10' 16, 'yank 20' 17, 'yank 40' 18, 'zero gravity' 19, 'zero gravity of cloths' 20, 'dropped on' 21, 'dropped on of cloths' 22, 'cross-strips' 23, 'cross-strips on edge' 24, 'tangled hung' 25, 'tangled dropped' 26, 'crossed 20' 27, 'crossed 42' 28, 'dress swung' 29, 'skirt swung' 30)
set terminal svg size 1300,904 font 'DejaVu Sans,13' background rgb 'white'
set output 'contact.svg'
set multiplot layout 1,2
set xrange [0.4:*]
set xlabel 'crossing pairs of triangles, none at 0.5'
plot $pairs0 using 2:3:($1-$2):(0) with vectors nohead linecolor rgb '#7f7f7f' notitle, $pairs0 using 1:3 with points pointtype 6 linecolor rgb '#7f7f7f' title 'off, peak', $pairs0 using 2:3 with points pointtype 7 linecolor rgb '#7f7f7f' title 'off, final', $pairs1 using 2:3:($1-$2):(0) with vectors nohead linecolor rgb '#1f77b4' notitle, $pairs1 using 1:3 with points pointtype 6 linecolor rgb '#1f77b4' title 'avoidance, peak', $pairs1 using 2:3 with points pointtype 7 linecolor rgb '#1f77b4' title 'avoidance, final', $pairs2 using 2:3:($1-$2):(0) with vectors nohead linecolor rgb '#d62728' notitle, $pairs2 using 1:3 with points pointtype 6 linecolor rgb '#d62728' title 'impact-zones, peak', $pairs2 using 2:3 with points pointtype 7 linecolor rgb '#d62728' title 'impact-zones, final', $pairs3 using 2:3:($1-$2):(0) with vectors nohead linecolor rgb '#2ca02c' notitle, $pairs3 using 1:3 with points pointtype 6 linecolor rgb '#2ca02c' title 'contact, peak', $pairs3 using 2:3 with points pointtype 7 linecolor rgb '#2ca02c' title 'contact, final'
set xrange [0.98:*]
set xlabel 'longest edge over its length at rest'
plot $edges0 using 2:3:($1-$2):(0) with vectors nohead linecolor rgb '#7f7f7f' notitle, $edges0 using 1:3 with points pointtype 6 linecolor rgb '#7f7f7f' title 'off, peak', $edges0 using 2:3 with points pointtype 7 linecolor rgb '#7f7f7f' title 'off, final', $edges1 using 2:3:($1-$2):(0) with vectors nohead linecolor rgb '#1f77b4' notitle, $edges1 using 1:3 with points pointtype 6 linecolor rgb '#1f77b4' title 'avoidance, peak', $edges1 using 2:3 with points pointtype 7 linecolor rgb '#1f77b4' title 'avoidance, final', $edges2 using 2:3:($1-$2):(0) with vectors nohead linecolor rgb '#d62728' notitle, $edges2 using 1:3 with points pointtype 6 linecolor rgb '#d62728' title 'impact-zones, peak', $edges2 using 2:3 with points pointtype 7 linecolor rgb '#d62728' title 'impact-zones, final', $edges3 using 2:3:($1-$2):(0) with vectors nohead linecolor rgb '#2ca02c' notitle, $edges3 using 1:3 with points pointtype 6 linecolor rgb '#2ca02c' title 'contact, peak', $edges3 using 2:3 with points pointtype 7 linecolor rgb '#2ca02c' title 'contact, final'
unset multiplot
set terminal pngcairo size 1300,904 font 'DejaVu Sans,10' background rgb 'white'
set output 'contact.png'
set multiplot layout 1,2
set xrange [0.4:*]
set xlabel 'crossing pairs of triangles, none at 0.5'
plot $pairs0 using 2:3:($1-$2):(0) with vectors nohead linecolor rgb '#7f7f7f' notitle, $pairs0 using 1:3 with points pointtype 6 linecolor rgb '#7f7f7f' title 'off, peak', $pairs0 using 2:3 with points pointtype 7 linecolor rgb '#7f7f7f' title 'off, final', $pairs1 using 2:3:($1-$2):(0) with vectors nohead linecolor rgb '#1f77b4' notitle, $pairs1 using 1:3 with points pointtype 6 linecolor rgb '#1f77b4' title 'avoidance, peak', $pairs1 using 2:3 with points pointtype 7 linecolor rgb '#1f77b4' title 'avoidance, final', $pairs2 using 2:3:($1-$2):(0) with vectors nohead linecolor rgb '#d62728' notitle, $pairs2 using 1:3 with points pointtype 6 linecolor rgb '#d62728' title 'impact-zones, peak', $pairs2 using 2:3 with points pointtype 7 linecolor rgb '#d62728' title 'impact-zones, final', $pairs3 using 2:3:($1-$2):(0) with vectors nohead linecolor rgb '#2ca02c' notitle, $pairs3 using 1:3 with points pointtype 6 linecolor rgb '#2ca02c' title 'contact, peak', $pairs3 using 2:3 with points pointtype 7 linecolor rgb '#2ca02c' title 'contact, final'
set xrange [0.98:*]
set xlabel 'longest edge over its length at rest'
plot $edges0 using 2:3:($1-$2):(0) with vectors nohead linecolor rgb '#7f7f7f' notitle, $edges0 using 1:3 with points pointtype 6 linecolor rgb '#7f7f7f' title 'off, peak', $edges0 using 2:3 with points pointtype 7 linecolor rgb '#7f7f7f' title 'off, final', $edges1 using 2:3:($1-$2):(0) with vectors nohead linecolor rgb '#1f77b4' notitle, $edges1 using 1:3 with points pointtype 6 linecolor rgb '#1f77b4' title 'avoidance, peak', $edges1 using 2:3 with points pointtype 7 linecolor rgb '#1f77b4' title 'avoidance, final', $edges2 using 2:3:($1-$2):(0) with vectors nohead linecolor rgb '#d62728' notitle, $edges2 using 1:3 with points pointtype 6 linecolor rgb '#d62728' title 'impact-zones, peak', $edges2 using 2:3 with points pointtype 7 linecolor rgb '#d62728' title 'impact-zones, final', $edges3 using 2:3:($1-$2):(0) with vectors nohead linecolor rgb '#2ca02c' notitle, $edges3 using 1:3 with points pointtype 6 linecolor rgb '#2ca02c' title 'contact, peak', $edges3 using 2:3 with points pointtype 7 linecolor rgb '#2ca02c' title 'contact, final'
unset multiplot
