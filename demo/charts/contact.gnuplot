$pairs0 << EOD
11939 4286 -0.125
342 185 0.875
0.5 0.5 1.875
43 0.5 2.875
911 0.5 3.875
630 0.5 4.875
0.5 0.5 5.875
0.5 0.5 6.875
12527 12056 7.875
12009 11489 8.875
2075 1179 9.875
3601 2533 10.875
1117 482 11.875
11317 2719 12.875
1183 1168 13.875
656 0.5 14.875
418 0.5 15.875
298 20 16.875
293 5 17.875
131 0.5 18.875
131 0.5 19.875
131 0.5 20.875
129 0.5 21.875
0.5 0.5 22.875
7 0.5 23.875
738 0.5 24.875
5713 2156 25.875
4928 3492 26.875
1805 814 27.875
EOD
$edges0 << EOD
1.52928 1.02303 -0.125
1.09024 1.00604 0.875
1.01368 1 1.875
1.03165 1 2.875
1.06205 1 3.875
1.07449 1 4.875
1.00002 1 5.875
1.00363 1 6.875
1.21306 1.04056 7.875
1.2137 1.03973 8.875
1.28452 1.03915 9.875
1.72075 1.03988 10.875
1.06906 1.04814 11.875
1.45161 1.0273 12.875
1.07973 1.03558 13.875
2.15232 1.55869 14.875
2.75412 1.55969 15.875
5.5348 1.55845 16.875
5.88108 1.5561 17.875
1.00561 1 18.875
1.00499 1 19.875
1.44112 1.23542 20.875
1.36932 1.19256 21.875
1.01278 1.00645 22.875
1.00372 1.00283 23.875
1.07631 1.03554 24.875
1.59664 1.02149 25.875
1.6078 1.35174 26.875
3.96676 1.43509 27.875
EOD
$pairs1 << EOD
11036 4014 0.125
1097 454 1.125
1146 0.5 2.125
1778 0.5 3.125
8242 0.5 4.125
15087 756 5.125
0.5 0.5 6.125
0.5 0.5 7.125
11973 9339 8.125
11911 11220 9.125
1612 992 10.125
2769 2386 11.125
534 517 12.125
18279 10026 13.125
1365 530 14.125
827 0.5 15.125
411 0.5 16.125
257 11 17.125
333 0.5 18.125
349 0.5 19.125
131 0.5 20.125
319 30 21.125
129 0.5 22.125
0.5 0.5 23.125
8 0.5 24.125
791 0.5 25.125
5769 2171 26.125
3773 2073 27.125
1400 261 28.125
EOD
$edges1 << EOD
1.55218 1.15075 0.125
1.39662 1.08971 1.125
1.32579 1.03961 2.125
1.54141 1.09312 3.125
1.4185 1.25654 4.125
1.50794 1.1689 5.125
1.00002 1 6.125
1.00363 1 7.125
1.58673 1.33878 8.125
1.43124 1.26504 9.125
1.54059 1.2602 10.125
1.71916 1.35301 11.125
1.39074 1.18936 12.125
1.8402 1.35293 13.125
1.50451 1.38412 14.125
2.4772 1.55804 15.125
4.02478 1.55898 16.125
5.53768 1.55787 17.125
5.88529 1.55878 18.125
1.31443 1.00138 19.125
1.00499 1 20.125
1.48733 1.24915 21.125
1.36932 1.19256 22.125
1.04432 1.00645 23.125
1.25261 1.00503 24.125
1.53364 1.03585 25.125
1.65327 1.22913 26.125
2.26559 1.80352 27.125
5.46623 1.43509 28.125
EOD
set yrange [28.5:-0.5]
set grid
set logscale x
set key outside top center horizontal
set ytics ('folddrop' 0, 'ribbon' 1, 'stack 2' 2, 'stack 3' 3, 'stack 5' 4, 'stack 10' 5, 'stack 2 of cloths' 6, 'stack 5 of cloths' 7, 'stacked' 8, 'stacked of cloths' 9, 'drape' 10, 'drape 16k' 11, 'gathered' 12, 'crumple' 13, 'twist' 14, 'yank 5' 15, 'yank 10' 16, 'yank 20' 17, 'yank 40' 18, 'zero gravity' 19, 'zero gravity of cloths' 20, 'dropped on' 21, 'dropped on of cloths' 22, 'cross-strips' 23, 'cross-strips on edge' 24, 'tangled hung' 25, 'tangled dropped' 26, 'dress swung' 27, 'skirt swung' 28)
set terminal svg size 1300,856 font 'DejaVu Sans,13' background rgb 'white'
set output 'contact.svg'
set multiplot layout 1,2
set xrange [0.4:*]
set xlabel 'crossing pairs of triangles, none at 0.5'
plot $pairs0 using 2:3:($1-$2):(0) with vectors nohead linecolor rgb '#7f7f7f' notitle, $pairs0 using 1:3 with points pointtype 6 linecolor rgb '#7f7f7f' title 'off, peak', $pairs0 using 2:3 with points pointtype 7 linecolor rgb '#7f7f7f' title 'off, final', $pairs1 using 2:3:($1-$2):(0) with vectors nohead linecolor rgb '#1f77b4' notitle, $pairs1 using 1:3 with points pointtype 6 linecolor rgb '#1f77b4' title 'avoidance, peak', $pairs1 using 2:3 with points pointtype 7 linecolor rgb '#1f77b4' title 'avoidance, final'
set xrange [0.98:*]
set xlabel 'longest edge over its length at rest'
plot $edges0 using 2:3:($1-$2):(0) with vectors nohead linecolor rgb '#7f7f7f' notitle, $edges0 using 1:3 with points pointtype 6 linecolor rgb '#7f7f7f' title 'off, peak', $edges0 using 2:3 with points pointtype 7 linecolor rgb '#7f7f7f' title 'off, final', $edges1 using 2:3:($1-$2):(0) with vectors nohead linecolor rgb '#1f77b4' notitle, $edges1 using 1:3 with points pointtype 6 linecolor rgb '#1f77b4' title 'avoidance, peak', $edges1 using 2:3 with points pointtype 7 linecolor rgb '#1f77b4' title 'avoidance, final'
unset multiplot
set terminal pngcairo size 1300,856 font 'DejaVu Sans,10' background rgb 'white'
set output 'contact.png'
set multiplot layout 1,2
set xrange [0.4:*]
set xlabel 'crossing pairs of triangles, none at 0.5'
plot $pairs0 using 2:3:($1-$2):(0) with vectors nohead linecolor rgb '#7f7f7f' notitle, $pairs0 using 1:3 with points pointtype 6 linecolor rgb '#7f7f7f' title 'off, peak', $pairs0 using 2:3 with points pointtype 7 linecolor rgb '#7f7f7f' title 'off, final', $pairs1 using 2:3:($1-$2):(0) with vectors nohead linecolor rgb '#1f77b4' notitle, $pairs1 using 1:3 with points pointtype 6 linecolor rgb '#1f77b4' title 'avoidance, peak', $pairs1 using 2:3 with points pointtype 7 linecolor rgb '#1f77b4' title 'avoidance, final'
set xrange [0.98:*]
set xlabel 'longest edge over its length at rest'
plot $edges0 using 2:3:($1-$2):(0) with vectors nohead linecolor rgb '#7f7f7f' notitle, $edges0 using 1:3 with points pointtype 6 linecolor rgb '#7f7f7f' title 'off, peak', $edges0 using 2:3 with points pointtype 7 linecolor rgb '#7f7f7f' title 'off, final', $edges1 using 2:3:($1-$2):(0) with vectors nohead linecolor rgb '#1f77b4' notitle, $edges1 using 1:3 with points pointtype 6 linecolor rgb '#1f77b4' title 'avoidance, peak', $edges1 using 2:3 with points pointtype 7 linecolor rgb '#1f77b4' title 'avoidance, final'
unset multiplot
