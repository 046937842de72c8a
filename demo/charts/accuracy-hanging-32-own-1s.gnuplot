set encoding utf8
set logscale xy
set format '%g'
set border 3 linecolor rgb '#495057'
set tics nomirror
set grid xtics ytics mxtics mytics linetype 1 linewidth 1 linecolor rgb '#dde2e6', linetype 1 linewidth 0.5 linecolor rgb '#eff2f5'
set xrange [0.0377545:35.3981]
set yrange [1.05958:1889.04]
set title 'Sheet hung by two corners, 32 × 32 particles: distance from the method''s own converged step after 1 s' noenhanced font ',13'
set xlabel 'median time of a frame of 1/60 s [ms]'
set ylabel 'RMS distance of particles [mm]'
set key outside right top Left reverse samplen 2 spacing 1.25 font ',10' noenhanced
set rmargin 42
set bmargin 8
set label 1 'Intel(R) Xeon(R) Processor; 2 threads, 2 used; commit 05b8bef; κ = 569; weft_study accuracy, then weft_study plot'."\n".'Not drawn, since they diverged: Explicit Euler substeps=72; Jacobi (Kang): even iterations=2' at screen 0.012, screen 0.085 font ',8' textcolor rgb '#6c757d' noenhanced
$curve0 << END
0.053935 1180.65 "iterations=1"
0.065594 1078.82 "iterations=3"
0.068582 945.35 "iterations=7"
0.148075 768.482 "iterations=15"
0.255229 667.657 "iterations=31"
0.476511 554.511 "iterations=63"
0.748145 447.554 "iterations=127"
1.61137 341.574 "iterations=255"
END
$curve1 << END
0.087925 790.366 "iterations=8"
0.140337 618.674 "iterations=16"
0.437609 435.826 "iterations=64"
END
$curve2 << END
0.058508 821.686 "iterations=1"
0.09767 581.772 "iterations=7"
0.279268 423.664 "iterations=31"
0.814601 286.436 "iterations=127"
END
$curve3 << END
0.054425 800.115 "iterations=4"
0.074594 628.348 "iterations=8"
0.114809 374.461 "iterations=16"
0.200673 110.903 "iterations=32"
0.357176 34.4168 "iterations=64"
0.705384 99.0015 "iterations=128"
END
$curve4 << END
0.061933 870.72 "iterations=4"
0.094926 638.481 "iterations=8"
0.160985 341.449 "iterations=16"
0.293493 149.538 "iterations=32"
0.627766 100.695 "iterations=64"
1.1669 103.545 "iterations=128"
END
$curve5 << END
0.113393 152.759 "iterations=1"
0.191 34.0259 "iterations=2"
0.211127 17.1071 "iterations=3"
0.2575 7.6217 "iterations=4"
0.319452 4.78607 "iterations=6"
0.417734 4.482 "iterations=8"
0.626524 4.30834 "iterations=12"
0.737629 4.88254 "iterations=16"
END
$curve6 << END
0.088546 152.622 "iterations=1"
0.115549 31.9859 "iterations=2"
0.176874 29.011 "iterations=4"
0.310996 29.6688 "iterations=8"
END
$curve7 << END
0.139997 21.0472 "passes=2 iterations=1"
0.169782 25.5697 "passes=2 iterations=2"
0.189202 13.8856 "passes=3 iterations=1"
0.218908 4.59078 "passes=3 iterations=2"
0.264266 5.75013 "passes=2 iterations=4"
0.304475 4.44212 "passes=4 iterations=1"
0.318402 2.21339 "passes=4 iterations=2"
0.326172 3.98385 "passes=3 iterations=4"
0.387042 1.96145 "passes=4 iterations=4"
0.411197 6.01961 "passes=2 iterations=6"
0.414034 3.57887 "passes=3 iterations=6"
0.523151 2.55667 "passes=6 iterations=1"
0.526885 1.51369 "passes=8 iterations=2"
0.55128 2.06399 "passes=6 iterations=2"
0.676632 2.42188 "passes=8 iterations=1"
END
$curve8 << END
0.11896 59.3914 "passes=1 iterations=2"
0.171215 62.7462 "passes=2 iterations=2"
0.235335 25.0097 "passes=3 iterations=2"
0.30994 18.5443 "passes=4 iterations=2"
0.382104 13.1764 "passes=4 iterations=4"
0.491445 9.71709 "passes=6 iterations=4"
END
$curve9 << END
22.1238 103.484 "one factorisation a step"
END
$curve10 << END
0.302026 45.7519 "passes=1 iterations=2"
0.50447 24.7529 "passes=2 iterations=2"
0.563861 11.9326 "passes=3 iterations=2"
0.66444 11.9743 "passes=4 iterations=2"
0.955679 8.58078 "passes=6 iterations=2"
END
$default << END
0.218908 4.59078 "passes=3 iterations=2"
END
set terminal svg size 1200,760 font 'DejaVu Sans,13' background rgb 'white'
set output 'accuracy-hanging-32-own-1s.svg'
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
set output 'accuracy-hanging-32-own-1s.png'
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
