$fixed << EOD
3.24524 3.5 0 "3 passes"
3.19667 3.428 6.82892 "1 pass"
1.44873 1.616 30.3462 "Jacobi of 15"
1.00164 1.171 36.3352 "Jacobi of 5"
1.82509 2.009 17.4176 "3 passes in 2 steps"
EOD
$budget << EOD
1.79315 1.987 17.3246 "2 ms"
2.0766 2.27 8.88517 "2.25 ms"
2.31955 2.519 8.12574 "2.5 ms"
2.567 2.787 6.71608 "2.75 ms"
2.81209 3.014 5.18621 "3 ms"
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
