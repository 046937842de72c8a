set encoding utf8
set logscale xy
set format '%g'
set border 3 linecolor rgb '#495057'
set tics nomirror
set grid xtics ytics mxtics mytics linetype 1 linewidth 1 linecolor rgb '#dde2e6', linetype 1 linewidth 0.5 linecolor rgb '#eff2f5'
set xrange [0.0133:20.624]
set yrange [0.450192:1805.82]
set title 'Sheet hung by two corners, 32 × 32 particles: distance from the method''s own converged step after 1 s' noenhanced font ',13'
set xlabel 'median time of a frame of 1/60 s [ms]'
set ylabel 'RMS distance of particles [mm]'
set key outside right top Left reverse samplen 2 spacing 1.25 font ',10' noenhanced
set rmargin 42
set bmargin 8
set label 1 'Intel(R) Xeon(R) Processor; 2 threads, 1 used; commit 12ab06f; κ = 569; weft_study accuracy, then weft_study plot'."\n".'Not drawn, since they diverged: Explicit Euler substeps=47; Fibres and sets iterations=1' at screen 0.012, screen 0.085 font ',8' textcolor rgb '#6c757d' noenhanced
$curve0 << END
0.019 1128.64 "iterations=1"
0.024 1097.91 "iterations=3"
0.036 977.007 "iterations=7"
0.057 791.39 "iterations=15"
0.1 645.119 "iterations=31"
0.185 526.255 "iterations=63"
0.357 421.53 "iterations=127"
0.707 311.824 "iterations=255"
END
$curve1 << END
0.022 631.456 "iterations=2"
0.039 500.517 "iterations=8"
0.061 357.492 "iterations=16"
0.188 265.481 "iterations=64"
END
$curve2 << END
0.033 786.5 "iterations=1"
0.048 549.356 "iterations=7"
0.114 396.299 "iterations=31"
0.37 281.834 "iterations=127"
END
$curve3 << END
0.028 853.847 "iterations=4"
0.04 566.784 "iterations=8"
0.062 313.527 "iterations=16"
0.106 66.2568 "iterations=32"
0.196 75.8721 "iterations=64"
0.376 88.3914 "iterations=128"
END
$curve4 << END
0.037 900.953 "iterations=4"
0.059 579.52 "iterations=8"
0.103 316.039 "iterations=16"
0.191 89.163 "iterations=32"
0.368 96.3969 "iterations=64"
0.722 92.0748 "iterations=128"
END
$curve5 << END
0.095 13.3826 "passes=2"
0.096 13.3104 "passes=1"
0.127 8.94555 "passes=3"
0.159 2.82037 "passes=4"
0.223 2.93258 "passes=6"
0.287 2.76399 "passes=8"
0.418 1.31558 "passes=12"
0.611 0.643132 "passes=18"
END
$curve6 << END
0.107 36.025 "passes=1"
0.128 30.2649 "passes=2"
0.13 24.5219 "passes=3"
0.161 10.4497 "passes=4"
0.235 5.04496 "passes=6"
0.295 4.38973 "passes=8"
0.423 3.59643 "passes=12"
END
$curve7 << END
0.302 149.101 "passes=1"
0.307 151.449 "passes=2"
0.41 156.309 "passes=3"
0.515 164.245 "passes=4"
0.723 168.204 "passes=6"
END
$curve8 << END
12.89 92.0756 "one factorisation a step"
END
$default << END
0.13 24.5219 "passes=3"
END
set terminal svg size 1200,760 font 'DejaVu Sans,13' background rgb 'white'
set output 'accuracy-hanging-32-own-1s.svg'
plot $curve0 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 7 linecolor rgb '#d62728' title 'Jacobi (Kang): odd', \
  $curve1 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#f4a6a6' title 'Jacobi (Kang): even', \
  $curve2 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 9 linecolor rgb '#8c1515' title 'Jacobi (Kang) with tethers', \
  $curve3 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 5 linecolor rgb '#f59f00' title 'Chebyshev', \
  $curve4 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 13 linecolor rgb '#b8860b' title 'Conjugate gradients', \
  $curve5 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 5 linecolor rgb '#0b3d91' title 'Multilevel: Newton passes', \
  $curve6 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 9 linecolor rgb '#2b8a3e' title 'Multilevel: BDF2', \
  $curve7 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 4 linecolor rgb '#087f5b' title 'Multilevel: finite elements', \
  $curve8 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 2 linecolor rgb '#000000' title 'Sparse Cholesky', \
  $default using 1:2 with points pointtype 3 pointsize 3 linewidth 3 linecolor rgb '#000000' title 'Weft''s default'
set terminal pngcairo size 1200,760 font 'DejaVu Sans,10' background rgb 'white'
set output 'accuracy-hanging-32-own-1s.png'
plot $curve0 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 7 linecolor rgb '#d62728' title 'Jacobi (Kang): odd', \
  $curve1 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#f4a6a6' title 'Jacobi (Kang): even', \
  $curve2 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 9 linecolor rgb '#8c1515' title 'Jacobi (Kang) with tethers', \
  $curve3 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 5 linecolor rgb '#f59f00' title 'Chebyshev', \
  $curve4 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 13 linecolor rgb '#b8860b' title 'Conjugate gradients', \
  $curve5 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 5 linecolor rgb '#0b3d91' title 'Multilevel: Newton passes', \
  $curve6 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 9 linecolor rgb '#2b8a3e' title 'Multilevel: BDF2', \
  $curve7 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 4 linecolor rgb '#087f5b' title 'Multilevel: finite elements', \
  $curve8 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 2 linecolor rgb '#000000' title 'Sparse Cholesky', \
  $default using 1:2 with points pointtype 3 pointsize 3 linewidth 3 linecolor rgb '#000000' title 'Weft''s default'
