set encoding utf8
set logscale xy
set format '%g'
set border 3 linecolor rgb '#495057'
set tics nomirror
set grid xtics ytics mxtics mytics linetype 1 linewidth 1 linecolor rgb '#dde2e6', linetype 1 linewidth 0.5 linecolor rgb '#eff2f5'
set xrange [0.07:271.626]
set yrange [1.20674:556.84]
set title 'Hung sheet in wind, 64 × 64 particles: distance from the method''s own converged step after 1 s' noenhanced font ',13'
set xlabel 'median time of a frame of 1/60 s [ms]'
set ylabel 'RMS distance of particles [mm]'
set key outside right top Left reverse samplen 2 spacing 1.25 font ',10' noenhanced
set rmargin 42
set bmargin 8
set label 1 'AMD EPYC; 2 threads, 1 used; commit 3697fc2; κ = 2276; weft_study accuracy, then weft_study plot'."\n".'Not drawn, since they diverged: Explicit Euler substeps=126; Fibres and sets in substeps iterations=1 substeps=4; Fibres and sets iterations=1'."\n".' Jacobi (Kang): even iterations=2' at screen 0.012, screen 0.085 font ',8' textcolor rgb '#6c757d' noenhanced
$curve0 << END
0.1 92.9578 "iterations=1"
0.125 106.253 "iterations=3"
0.172 137.309 "iterations=7"
0.265 145.353 "iterations=15"
0.454 87.0062 "iterations=31"
0.836 44.3475 "iterations=63"
1.608 32.4788 "iterations=127"
3.16 22.5354 "iterations=255"
END
$curve1 << END
0.182 279.734 "iterations=8"
0.277 348.025 "iterations=16"
0.845 235.791 "iterations=64"
END
$curve2 << END
0.148 49.6909 "iterations=1"
0.21 121.992 "iterations=7"
0.49 86.302 "iterations=31"
1.652 42.7169 "iterations=127"
END
$curve3 << END
0.139 153.138 "iterations=4"
0.188 74.9731 "iterations=8"
0.287 29.215 "iterations=16"
0.49 17.3766 "iterations=32"
0.91 12.4147 "iterations=64"
1.746 13.6725 "iterations=128"
END
$curve4 << END
0.181 150.436 "iterations=4"
0.284 64.9524 "iterations=8"
0.491 28.3835 "iterations=16"
0.916 17.1851 "iterations=32"
1.751 13.3692 "iterations=64"
3.441 13.2569 "iterations=128"
END
$curve5 << END
0.232 32.5892 "iterations=1"
0.32 19.0747 "iterations=2"
0.487 7.58872 "iterations=4"
0.804 8.00822 "iterations=8"
END
$curve6 << END
0.354 10.8268 "passes=2 iterations=1"
0.443 4.87256 "passes=2 iterations=2"
0.497 4.87677 "passes=3 iterations=1"
0.573 2.37674 "passes=3 iterations=2"
0.603 3.00761 "passes=4 iterations=1"
0.606 4.77514 "passes=2 iterations=4"
0.681 1.92436 "passes=4 iterations=2"
0.725 2.16254 "passes=3 iterations=4"
0.781 5.34615 "passes=2 iterations=6"
0.876 1.96645 "passes=4 iterations=4"
0.891 2.53546 "passes=6 iterations=1"
0.909 2.24295 "passes=3 iterations=6"
0.984 2.01686 "passes=6 iterations=2"
1.148 2.20196 "passes=8 iterations=1"
1.252 1.72392 "passes=8 iterations=2"
END
$curve7 << END
0.453 26.4904 "passes=2 iterations=2"
0.483 26.7118 "passes=1 iterations=2"
0.582 25.7883 "passes=3 iterations=2"
0.718 11.1728 "passes=4 iterations=2"
0.878 21.1254 "passes=4 iterations=4"
1.166 6.06911 "passes=6 iterations=4"
END
$curve8 << END
1.127 29.5134 "passes=1 iterations=2"
1.498 15.2829 "passes=2 iterations=2"
1.993 11.9951 "passes=3 iterations=2"
2.466 10.8277 "passes=4 iterations=2"
3.499 9.42975 "passes=6 iterations=2"
END
$curve9 << END
169.766 13.3155 "one factorisation a step"
END
$default << END
0.582 25.7883 "passes=3 iterations=2"
END
set terminal svg size 1200,760 font 'DejaVu Sans,13' background rgb 'white'
set output 'accuracy-wind-64-own-1s.svg'
plot $curve0 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 7 linecolor rgb '#d62728' title 'Jacobi (Kang): odd', \
  $curve1 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#f4a6a6' title 'Jacobi (Kang): even', \
  $curve2 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 9 linecolor rgb '#8c1515' title 'Jacobi (Kang) with tethers', \
  $curve3 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 5 linecolor rgb '#f59f00' title 'Chebyshev', \
  $curve4 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 13 linecolor rgb '#b8860b' title 'Conjugate gradients', \
  $curve5 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#74c0fc' title 'Multilevel: one linear solve', \
  $curve6 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 5 linecolor rgb '#0b3d91' title 'Multilevel: Newton passes', \
  $curve7 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 9 linecolor rgb '#2b8a3e' title 'Multilevel: BDF2', \
  $curve8 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 4 linecolor rgb '#087f5b' title 'Multilevel: finite elements', \
  $curve9 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 2 linecolor rgb '#000000' title 'Sparse Cholesky', \
  $default using 1:2 with points pointtype 3 pointsize 3 linewidth 3 linecolor rgb '#000000' title 'Weft''s default'
set terminal pngcairo size 1200,760 font 'DejaVu Sans,10' background rgb 'white'
set output 'accuracy-wind-64-own-1s.png'
plot $curve0 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 7 linecolor rgb '#d62728' title 'Jacobi (Kang): odd', \
  $curve1 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#f4a6a6' title 'Jacobi (Kang): even', \
  $curve2 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 9 linecolor rgb '#8c1515' title 'Jacobi (Kang) with tethers', \
  $curve3 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 5 linecolor rgb '#f59f00' title 'Chebyshev', \
  $curve4 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 13 linecolor rgb '#b8860b' title 'Conjugate gradients', \
  $curve5 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#74c0fc' title 'Multilevel: one linear solve', \
  $curve6 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 5 linecolor rgb '#0b3d91' title 'Multilevel: Newton passes', \
  $curve7 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 9 linecolor rgb '#2b8a3e' title 'Multilevel: BDF2', \
  $curve8 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 4 linecolor rgb '#087f5b' title 'Multilevel: finite elements', \
  $curve9 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 2 linecolor rgb '#000000' title 'Sparse Cholesky', \
  $default using 1:2 with points pointtype 3 pointsize 3 linewidth 3 linecolor rgb '#000000' title 'Weft''s default'
