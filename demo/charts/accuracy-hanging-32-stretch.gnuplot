set encoding utf8
set logscale xy
set format '%g'
set border 3 linecolor rgb '#495057'
set tics nomirror
set grid xtics ytics mxtics mytics linetype 1 linewidth 1 linecolor rgb '#dde2e6', linetype 1 linewidth 0.5 linecolor rgb '#eff2f5'
set xrange [0.0155029:30.5173]
set yrange [1.04114:5875.79]
set title 'Sheet hung by two corners, 32 × 32 particles: worst stretch of a thread after 1 s' noenhanced font ',13'
set xlabel 'median time of a frame of 1/60 s [ms]'
set ylabel 'worst stretch [%]'
set key outside right top Left reverse samplen 2 spacing 1.25 font ',10' noenhanced
set rmargin 42
set bmargin 8
set label 1 'Intel(R) Xeon(R) Processor; 2 threads, 2 used; commit d3fa699+; κ = 569; weft_study accuracy, then weft_study plot'."\n".'Not drawn, since they diverged: Explicit Euler substeps=72; Jacobi (Kang): even iterations=2' at screen 0.012, screen 0.085 font ',8' textcolor rgb '#6c757d' noenhanced
$curve0 << END
0.022147 288.783 "iterations=1"
0.028901 191.379 "iterations=3"
0.042752 79.0763 "iterations=7"
0.071287 47.1715 "iterations=15"
0.127765 21.8977 "iterations=31"
0.241328 18.3961 "iterations=63"
0.461341 5.09988 "iterations=127"
0.936175 6.88268 "iterations=255"
END
$curve1 << END
0.046689 228.369 "iterations=8"
0.075001 310.423 "iterations=16"
0.241184 90.5399 "iterations=64"
END
$curve2 << END
0.036462 36.81 "iterations=1"
0.057635 11.3753 "iterations=7"
0.14062 2.32244 "iterations=31"
0.474715 3.6283 "iterations=127"
END
$curve3 << END
0.082685 35.0668 "iterations=7 substeps=2"
0.161123 1.48734 "iterations=7 substeps=4"
0.317522 7.23059 "iterations=7 substeps=8"
0.63727 3.78975 "iterations=7 substeps=16"
END
$curve4 << END
0.034989 78.2083 "iterations=4"
0.049635 20.8346 "iterations=8"
0.077241 3.67692 "iterations=16"
0.134705 4.86998 "iterations=32"
0.249527 4.13176 "iterations=64"
0.493812 3.54192 "iterations=128"
END
$curve5 << END
0.042921 53.195 "iterations=4"
0.070987 16.6582 "iterations=8"
0.128018 7.84215 "iterations=16"
0.242139 5.19423 "iterations=32"
0.471533 3.62465 "iterations=64"
0.934494 3.63048 "iterations=128"
END
$curve6 << END
0.079828 4.49524 "iterations=1"
0.108225 3.64709 "iterations=2"
0.140357 3.93973 "iterations=3"
0.167163 3.84415 "iterations=4"
0.222973 3.78371 "iterations=6"
0.27449 3.97092 "iterations=8"
0.398857 4.00134 "iterations=12"
0.504583 4.09879 "iterations=16"
END
$curve7 << END
0.066324 4.50125 "iterations=1"
0.087207 3.33918 "iterations=2"
0.131943 3.19587 "iterations=4"
0.219243 3.27007 "iterations=8"
END
$curve8 << END
0.097394 3.43487 "passes=2 iterations=1"
0.118705 4.27465 "passes=2 iterations=2"
0.126108 4.09176 "passes=3 iterations=1"
0.149123 4.20406 "passes=3 iterations=2"
0.160958 4.0259 "passes=4 iterations=1"
0.162635 4.0234 "passes=2 iterations=4"
0.178854 4.19879 "passes=4 iterations=2"
0.191597 4.09127 "passes=3 iterations=4"
0.205648 4.02087 "passes=2 iterations=6"
0.218668 4.12762 "passes=6 iterations=1"
0.22426 4.12592 "passes=4 iterations=4"
0.236619 4.10635 "passes=3 iterations=6"
0.24122 4.16788 "passes=6 iterations=2"
0.280414 4.1431 "passes=8 iterations=1"
0.301969 4.16114 "passes=8 iterations=2"
END
$curve9 << END
0.127283 4.33533 "passes=1 substeps=2"
0.251314 5.24331 "passes=1 substeps=4"
0.509747 4.21022 "passes=1 substeps=8"
1.03045 3.28269 "passes=1 substeps=16"
END
$curve10 << END
0.09063 2.13877 "passes=1 iterations=2"
0.12168 3.59453 "passes=2 iterations=2"
0.152 2.52832 "passes=3 iterations=2"
0.183338 2.3718 "passes=4 iterations=2"
0.22531 2.0403 "passes=4 iterations=4"
0.2877 2.22644 "passes=6 iterations=4"
END
$curve11 << END
0.301943 3.13005 "passes=3 substeps=2"
0.611668 3.57232 "passes=3 substeps=4"
1.21565 5.24303 "passes=3 substeps=8"
END
$curve12 << END
0.270343 8.63212 "passes=1 iterations=2"
0.377006 7.4783 "passes=2 iterations=2"
0.487787 7.89772 "passes=3 iterations=2"
0.604996 7.94614 "passes=4 iterations=2"
0.827837 8.05284 "passes=6 iterations=2"
END
$curve13 << END
0.031173 3672.37 "substeps=1"
0.052354 517.213 "substeps=2"
0.1018 109.625 "substeps=4"
0.192346 20.0979 "substeps=8"
0.383305 5.66738 "substeps=16"
0.786081 7.2713 "substeps=32"
1.55263 5.51264 "substeps=64"
END
$curve14 << END
0.07918 456.761 "iterations=4"
0.284973 86.6658 "iterations=16"
1.13067 22.5013 "iterations=64"
END
$curve15 << END
0.034456 3235.8 "iterations=1"
0.098605 331.103 "iterations=4"
0.359122 50.0134 "iterations=16"
1.43423 20.3088 "iterations=64"
END
$curve16 << END
0.12005 54.9635 "iterations=1 substeps=4"
0.470019 12.8254 "iterations=1 substeps=16"
1.92365 6.8582 "iterations=1 substeps=64"
END
$curve17 << END
0.584773 5.49528 "substeps=72"
0.901584 4.57855 "substeps=111"
1.83529 5.20733 "substeps=222"
END
$curve18 << END
2.25661 5.88265 "substeps=222"
END
$curve19 << END
19.0733 3.63004 "one factorisation a step"
END
$default << END
0.149123 4.20406 "passes=3 iterations=2"
END
set terminal svg size 1200,760 font 'DejaVu Sans,13' background rgb 'white'
set output 'accuracy-hanging-32-stretch.svg'
plot 5.35068 with lines dashtype 2 linewidth 1.2 linecolor rgb '#495057' title 'the true motion (tiny steps)', \
  $curve0 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 7 linecolor rgb '#d62728' title 'Jacobi (Kang): odd', \
  $curve1 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#f4a6a6' title 'Jacobi (Kang): even', \
  $curve2 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 9 linecolor rgb '#8c1515' title 'Jacobi (Kang) with tethers', \
  $curve3 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 8 linecolor rgb '#e8590c' title 'Jacobi (Kang) in substeps', \
  $curve4 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 5 linecolor rgb '#f59f00' title 'Chebyshev', \
  $curve5 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 13 linecolor rgb '#b8860b' title 'Conjugate gradients', \
  $curve6 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 7 linecolor rgb '#1f77b4' title 'Multilevel: nonlinear CG', \
  $curve7 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#74c0fc' title 'Multilevel: one linear solve', \
  $curve8 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 5 linecolor rgb '#0b3d91' title 'Multilevel: Newton passes', \
  $curve9 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 8 linecolor rgb '#15aabf' title 'Multilevel in substeps', \
  $curve10 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 9 linecolor rgb '#2b8a3e' title 'Multilevel: BDF2', \
  $curve11 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 11 linecolor rgb '#74b816' title 'Multilevel: BDF2 in substeps', \
  $curve12 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 4 linecolor rgb '#087f5b' title 'Multilevel: finite elements', \
  $curve13 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 7 linecolor rgb '#9c36b5' title 'XPBD: substeps', \
  $curve14 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#da77f2' title 'XPBD: iterations', \
  $curve15 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 13 linecolor rgb '#e64980' title 'Fibres and sets', \
  $curve16 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 12 linecolor rgb '#f783ac' title 'Fibres and sets in substeps', \
  $curve17 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 15 linecolor rgb '#495057' title 'Symplectic Euler', \
  $curve18 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 14 linecolor rgb '#adb5bd' title 'Explicit Euler', \
  $curve19 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 2 linecolor rgb '#000000' title 'Sparse Cholesky', \
  $default using 1:2 with points pointtype 3 pointsize 3 linewidth 3 linecolor rgb '#000000' title 'Weft''s default'
set terminal pngcairo size 1200,760 font 'DejaVu Sans,10' background rgb 'white'
set output 'accuracy-hanging-32-stretch.png'
plot 5.35068 with lines dashtype 2 linewidth 1.2 linecolor rgb '#495057' title 'the true motion (tiny steps)', \
  $curve0 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 7 linecolor rgb '#d62728' title 'Jacobi (Kang): odd', \
  $curve1 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#f4a6a6' title 'Jacobi (Kang): even', \
  $curve2 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 9 linecolor rgb '#8c1515' title 'Jacobi (Kang) with tethers', \
  $curve3 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 8 linecolor rgb '#e8590c' title 'Jacobi (Kang) in substeps', \
  $curve4 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 5 linecolor rgb '#f59f00' title 'Chebyshev', \
  $curve5 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 13 linecolor rgb '#b8860b' title 'Conjugate gradients', \
  $curve6 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 7 linecolor rgb '#1f77b4' title 'Multilevel: nonlinear CG', \
  $curve7 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#74c0fc' title 'Multilevel: one linear solve', \
  $curve8 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 5 linecolor rgb '#0b3d91' title 'Multilevel: Newton passes', \
  $curve9 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 8 linecolor rgb '#15aabf' title 'Multilevel in substeps', \
  $curve10 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 9 linecolor rgb '#2b8a3e' title 'Multilevel: BDF2', \
  $curve11 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 11 linecolor rgb '#74b816' title 'Multilevel: BDF2 in substeps', \
  $curve12 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 4 linecolor rgb '#087f5b' title 'Multilevel: finite elements', \
  $curve13 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 7 linecolor rgb '#9c36b5' title 'XPBD: substeps', \
  $curve14 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#da77f2' title 'XPBD: iterations', \
  $curve15 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 13 linecolor rgb '#e64980' title 'Fibres and sets', \
  $curve16 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 12 linecolor rgb '#f783ac' title 'Fibres and sets in substeps', \
  $curve17 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 15 linecolor rgb '#495057' title 'Symplectic Euler', \
  $curve18 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 14 linecolor rgb '#adb5bd' title 'Explicit Euler', \
  $curve19 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 2 linecolor rgb '#000000' title 'Sparse Cholesky', \
  $default using 1:2 with points pointtype 3 pointsize 3 linewidth 3 linecolor rgb '#000000' title 'Weft''s default'
