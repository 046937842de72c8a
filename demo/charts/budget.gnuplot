$fixed << EOD
2.9363 3.095 0 "3 passes of 3 iterations"
2.94281 4.067 5.97776 "2 passes of 3"
1.94771 2.092 10.5506 "2 passes of 1"
1.76668 1.903 10.9293 "1 pass of 2"
1.51231 1.643 15.4199 "1 pass of 1"
1.32039 1.508 30.0401 "Jacobi of 15"
0.962538 1.142 36.3678 "Jacobi of 5"
0.863632 1.024 28.6996 "1 pass in 2 steps"
0.493093 0.6 38.3961 "1 pass in 4 steps"
EOD
$budget << EOD
0.895599 1.051 16.7272 "1 ms"
1.39551 1.546 9.93981 "1.5 ms"
1.88702 2.041 6.63287 "2 ms"
2.36212 2.517 5.94795 "2.5 ms"
2.79177 2.992 5.61737 "3 ms"
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
