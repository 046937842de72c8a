set encoding utf8
set logscale xy
set format '%g'
set border 3 linecolor rgb '#495057'
set tics nomirror
set grid xtics ytics mxtics mytics linetype 1 linewidth 1 linecolor rgb '#dde2e6', linetype 1 linewidth 0.5 linecolor rgb '#eff2f5'
set xrange [0.0783734:373.478]
set yrange [1.63013:1916.88]
set title 'Sheet hung by two corners, 64 × 64 particles: distance from the method''s own converged step after 1 s' noenhanced font ',13'
set xlabel 'median time of a frame of 1/60 s [ms]'
set ylabel 'RMS distance of particles [mm]'
set key outside right top Left reverse samplen 2 spacing 1.25 font ',10' noenhanced
set rmargin 42
set bmargin 8
set label 1 'Intel(R) Xeon(R) Processor; 2 threads, 2 used; commit 05b8bef; κ = 2276; weft_study accuracy, then weft_study plot'."\n".'Not drawn, since they diverged: Fibres and sets in substeps iterations=1 substeps=4; Fibres and sets iterations=1' at screen 0.012, screen 0.085 font ',8' textcolor rgb '#6c757d' noenhanced
$curve0 << END
0.111962 1130.66 "iterations=1"
0.141157 1195.8 "iterations=3"
0.210721 1198.05 "iterations=7"
0.316762 1111.4 "iterations=15"
0.54612 977.972 "iterations=31"
0.91869 799.149 "iterations=63"
1.66683 678.758 "iterations=127"
3.27224 570.547 "iterations=255"
END
$curve1 << END
0.112371 1089.23 "iterations=2"
0.192032 1097.64 "iterations=8"
0.321974 1008.97 "iterations=16"
0.893651 746.111 "iterations=64"
END
$curve2 << END
0.134787 883.531 "iterations=1"
0.204678 751.388 "iterations=7"
0.511017 584.832 "iterations=31"
1.776 427.646 "iterations=127"
END
$curve3 << END
0.14448 1079.02 "iterations=4"
0.19326 913.799 "iterations=8"
0.291977 642.502 "iterations=16"
0.520393 355.264 "iterations=32"
0.896083 134.476 "iterations=64"
1.67674 36.7358 "iterations=128"
END
$curve4 << END
0.1809 1107.81 "iterations=4"
0.302027 907.392 "iterations=8"
0.549477 669.86 "iterations=16"
1.05718 388.118 "iterations=32"
2.06211 158.243 "iterations=64"
4.08178 90.7797 "iterations=128"
END
$curve5 << END
0.315632 114.941 "iterations=1"
0.430896 31.2996 "iterations=2"
0.592951 22.2365 "iterations=3"
0.73466 12.9032 "iterations=4"
0.987082 10.77 "iterations=6"
1.22965 21.1235 "iterations=8"
1.82281 3.80545 "iterations=12"
2.29564 4.1556 "iterations=16"
END
$curve6 << END
0.23618 115.49 "iterations=1"
0.330875 36.41 "iterations=2"
0.512334 29.9974 "iterations=4"
0.875454 22.4795 "iterations=8"
END
$curve7 << END
0.385769 34.0076 "passes=2 iterations=1"
0.459097 11.0124 "passes=2 iterations=2"
0.508157 24.9325 "passes=3 iterations=1"
0.611891 8.61988 "passes=3 iterations=2"
0.640371 14.1966 "passes=4 iterations=1"
0.652214 4.22172 "passes=2 iterations=4"
0.727416 4.0418 "passes=4 iterations=2"
0.848337 3.73352 "passes=3 iterations=4"
0.892351 3.9142 "passes=2 iterations=6"
0.911425 7.79408 "passes=6 iterations=1"
0.914295 2.54696 "passes=4 iterations=4"
0.967231 2.99268 "passes=3 iterations=6"
1.00383 2.61104 "passes=6 iterations=2"
1.21324 3.3212 "passes=8 iterations=1"
1.31492 2.32876 "passes=8 iterations=2"
END
$curve8 << END
0.334725 41.0929 "passes=1 iterations=2"
0.466479 40.8071 "passes=2 iterations=2"
0.61085 26.2541 "passes=3 iterations=2"
0.753085 23.2365 "passes=4 iterations=2"
0.94433 19.1001 "passes=4 iterations=4"
1.21031 17.8881 "passes=6 iterations=4"
END
$curve9 << END
233.424 96.8369 "one factorisation a step"
END
$curve10 << END
0.734786 47.4001 "passes=1 iterations=2"
1.00188 28.7838 "passes=2 iterations=2"
1.32901 14.6077 "passes=3 iterations=2"
1.61981 8.43783 "passes=4 iterations=2"
2.24029 5.92693 "passes=6 iterations=2"
END
$default << END
0.611891 8.61988 "passes=3 iterations=2"
END
set terminal svg size 1200,760 font 'DejaVu Sans,13' background rgb 'white'
set output 'accuracy-hanging-64-own-1s.svg'
plot $curve0 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 7 linecolor rgb '#d62728' title 'Jacobi (Kang): odd', \
  $curve1 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#f4a6a6' title 'Jacobi (Kang): even', \
  $curve2 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 9 linecolor rgb '#8c1515' title 'Jacobi (Kang) with tethers', \
  $curve3 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 5 linecolor rgb '#f59f00' title 'Chebyshev', \
  $curve4 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 13 linecolor rgb '#b8860b' title 'Conjugate gradients', \
  $curve5 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 7 linecolor rgb '#1f77b4' title 'Multilevel: nonlinear CG', \
  $curve6 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#74c0fc' title 'Multilevel: one linear solve', \
  $curve7 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 5 linecolor rgb '#0b3d91' title 'Multilevel: Newton passes', \
  $curve8 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 9 linecolor rgb '#2b8a3e' title 'Multilevel: BDF2', \
  $curve9 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 2 linecolor rgb '#000000' title 'Sparse Cholesky', \
  $curve10 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 4 linecolor rgb '#087f5b' title 'Multilevel: finite elements', \
  $default using 1:2 with points pointtype 3 pointsize 3 linewidth 3 linecolor rgb '#000000' title 'Weft''s default'
set terminal pngcairo size 1200,760 font 'DejaVu Sans,10' background rgb 'white'
set output 'accuracy-hanging-64-own-1s.png'
plot $curve0 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 7 linecolor rgb '#d62728' title 'Jacobi (Kang): odd', \
  $curve1 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#f4a6a6' title 'Jacobi (Kang): even', \
  $curve2 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 9 linecolor rgb '#8c1515' title 'Jacobi (Kang) with tethers', \
  $curve3 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 5 linecolor rgb '#f59f00' title 'Chebyshev', \
  $curve4 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 13 linecolor rgb '#b8860b' title 'Conjugate gradients', \
  $curve5 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 7 linecolor rgb '#1f77b4' title 'Multilevel: nonlinear CG', \
  $curve6 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#74c0fc' title 'Multilevel: one linear solve', \
  $curve7 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 5 linecolor rgb '#0b3d91' title 'Multilevel: Newton passes', \
  $curve8 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 9 linecolor rgb '#2b8a3e' title 'Multilevel: BDF2', \
  $curve9 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 2 linecolor rgb '#000000' title 'Sparse Cholesky', \
  $curve10 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 4 linecolor rgb '#087f5b' title 'Multilevel: finite elements', \
  $default using 1:2 with points pointtype 3 pointsize 3 linewidth 3 linecolor rgb '#000000' title 'Weft''s default'
