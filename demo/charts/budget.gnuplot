$fixed << EOD
4.59739 5.043 0 "3 passes of 2 iterations"
4.43637 4.888 5.4095 "2 passes of 2"
3.16692 3.957 10.002 "2 passes of 1"
2.15207 2.451 10.7794 "1 pass of 2"
1.81314 2.076 15.2896 "1 pass of 1"
1.62203 1.848 30.0331 "Jacobi of 15"
1.10461 1.312 36.3765 "Jacobi of 5"
1.17731 1.64 28.5757 "1 pass in 2 steps"
0.680213 0.886 38.4311 "1 pass in 4 steps"
EOD
$budget << EOD
0.815346 1.056 33.4072 "1 ms"
1.25366 1.57 19.2965 "1.5 ms"
1.74021 2.108 10.4436 "2 ms"
2.23395 2.582 5.87896 "2.5 ms"
2.66057 3.129 7.40102 "3 ms"
EOD
set title 'Fifty curtains in gusts round a camera that turns, on one thread'
set xlabel 'a step, mean and 99th percentile [ms of the processor]'
set ylabel 'as seen, off the cloth as it is set, rms [mrad]'
set yrange [0:*]
set xrange [0:*]
set grid
set key top right
set terminal svg size 900,560 font 'DejaVu Sans,13' background rgb 'white'
set output 'budget.svg'
plot $fixed using 1:3:($2-$1):(0) with vectors nohead linecolor rgb '#7f7f7f' notitle, $fixed using 1:3 with points pointtype 7 linecolor rgb '#7f7f7f' title 'one setting for all', $fixed using 1:3:4 with labels left offset 0.7,0.7 font ',9' notitle, $budget using 1:3:($2-$1):(0) with vectors nohead linecolor rgb '#d62728' notitle, $budget using 1:3 with points pointtype 7 linecolor rgb '#d62728' title 'a budget', $budget using 1:3:4 with labels left offset 0.7,0.7 font ',9' notitle
set terminal pngcairo size 900,560 font 'DejaVu Sans,10' background rgb 'white'
set output 'budget.png'
plot $fixed using 1:3:($2-$1):(0) with vectors nohead linecolor rgb '#7f7f7f' notitle, $fixed using 1:3 with points pointtype 7 linecolor rgb '#7f7f7f' title 'one setting for all', $fixed using 1:3:4 with labels left offset 0.7,0.7 font ',9' notitle, $budget using 1:3:($2-$1):(0) with vectors nohead linecolor rgb '#d62728' notitle, $budget using 1:3 with points pointtype 7 linecolor rgb '#d62728' title 'a budget', $budget using 1:3:4 with labels left offset 0.7,0.7 font ',9' notitle
