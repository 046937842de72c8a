set encoding utf8
set logscale xy
set format '%g'
set border 3 linecolor rgb '#495057'
set tics nomirror
set grid xtics ytics mxtics mytics linetype 1 linewidth 1 linecolor rgb '#dde2e6', linetype 1 linewidth 0.5 linecolor rgb '#eff2f5'
set xrange [0.0602:270.744]
set yrange [2.59936:16301.3]
set title 'Sheet hung by two corners, 64 × 64 particles: worst stretch of a thread after 1 s' noenhanced font ',13'
set xlabel 'median time of a frame of 1/60 s [ms]'
set ylabel 'worst stretch [%]'
set key outside right top Left reverse samplen 2 spacing 1.25 font ',10' noenhanced
set rmargin 42
set bmargin 8
set label 1 'AMD EPYC; 2 threads, 1 used; commit 3697fc2; κ = 2276; weft_study accuracy, then weft_study plot'."\n".'Not drawn, since they diverged: Explicit Euler substeps=126; Fibres and sets in substeps iterations=1 substeps=4; Fibres and sets iterations=1'."\n".' Fibres and sets iterations=4; Jacobi (Kang): even iterations=2' at screen 0.012, screen 0.085 font ',8' textcolor rgb '#6c757d' noenhanced
$curve0 << END
0.086 125.305 "iterations=1"
0.109 206.024 "iterations=3"
0.156 242.182 "iterations=7"
0.251 269.342 "iterations=15"
0.45 321.76 "iterations=31"
0.844 164.361 "iterations=63"
1.638 77.6017 "iterations=127"
3.184 54.9313 "iterations=255"
END
$curve1 << END
0.169 490.462 "iterations=8"
0.268 490.953 "iterations=16"
0.866 173.129 "iterations=64"
END
$curve2 << END
0.134 4.02412 "iterations=1"
0.202 4.62357 "iterations=7"
0.505 3.71337 "iterations=31"
1.714 4.73926 "iterations=127"
END
$curve3 << END
0.305 302.287 "iterations=7 substeps=2"
0.597 302.699 "iterations=7 substeps=4"
1.192 5.50229 "iterations=7 substeps=8"
2.422 21.5532 "iterations=7 substeps=16"
END
$curve4 << END
0.125 266.374 "iterations=4"
0.176 357.402 "iterations=8"
0.274 180.391 "iterations=16"
0.488 28.9473 "iterations=32"
0.921 15.4212 "iterations=64"
1.746 14.3549 "iterations=128"
END
$curve5 << END
0.169 272.917 "iterations=4"
0.273 251.706 "iterations=8"
0.484 72.2384 "iterations=16"
0.928 27.2111 "iterations=32"
1.789 16.5129 "iterations=64"
3.495 13.8726 "iterations=128"
END
$curve6 << END
0.257 14.8726 "iterations=1"
0.473 15.2616 "iterations=2"
0.679 14.8202 "iterations=4"
0.995 14.6087 "iterations=8"
END
$curve7 << END
0.349 14.421 "passes=2 iterations=1"
0.431 15.3039 "passes=2 iterations=2"
0.492 14.3628 "passes=3 iterations=1"
0.575 15.1497 "passes=3 iterations=2"
0.601 14.8088 "passes=2 iterations=4"
0.622 14.4447 "passes=4 iterations=1"
0.706 15.1963 "passes=4 iterations=2"
0.762 14.6741 "passes=2 iterations=6"
0.778 14.9132 "passes=3 iterations=4"
0.884 14.8155 "passes=6 iterations=1"
0.896 14.8952 "passes=4 iterations=4"
0.905 14.9732 "passes=3 iterations=6"
1.005 14.9794 "passes=6 iterations=2"
1.202 14.8873 "passes=8 iterations=1"
1.297 14.9066 "passes=8 iterations=2"
END
$curve8 << END
0.511 15.7416 "passes=1 substeps=2"
1.03 15.8308 "passes=1 substeps=4"
1.98 13.387 "passes=1 substeps=8"
4.324 13.8253 "passes=1 substeps=16"
END
$curve9 << END
0.48 14.9694 "passes=2 iterations=2"
0.49 15.7122 "passes=1 iterations=2"
0.602 6.92232 "passes=3 iterations=2"
0.725 7.55806 "passes=4 iterations=2"
0.904 6.55113 "passes=4 iterations=4"
1.183 5.99017 "passes=6 iterations=4"
END
$curve10 << END
1.209 7.30795 "passes=3 substeps=2"
2.435 9.25499 "passes=3 substeps=4"
4.893 9.54283 "passes=3 substeps=8"
END
$curve11 << END
1.583 16.8013 "passes=1 iterations=2"
1.715 14.483 "passes=2 iterations=2"
2.308 14.6102 "passes=3 iterations=2"
2.688 15.4442 "passes=4 iterations=2"
3.57 15.8339 "passes=6 iterations=2"
END
$curve12 << END
0.202 10188.3 "substeps=1"
0.393 6969.2 "substeps=2"
0.777 2672.14 "substeps=4"
1.573 284.281 "substeps=8"
3.164 41.2432 "substeps=16"
6.364 12.2388 "substeps=32"
12.672 6.81458 "substeps=64"
END
$curve13 << END
0.333 7019.07 "iterations=4"
0.881 2375.11 "iterations=16"
3.007 233.265 "iterations=64"
END
$curve14 << END
0.925 1589.04 "iterations=16"
3.275 155.132 "iterations=64"
END
$curve15 << END
3.306 30.3117 "iterations=1 substeps=16"
12.957 9.12699 "iterations=1 substeps=64"
END
$curve16 << END
4.486 9.40889 "substeps=126"
6.734 8.47964 "substeps=193"
13.467 9.7979 "substeps=386"
END
$curve17 << END
18.884 10.8882 "substeps=386"
END
$curve18 << END
169.215 14.2967 "one factorisation a step"
END
$default << END
0.602 6.92232 "passes=3 iterations=2"
END
set terminal svg size 1200,760 font 'DejaVu Sans,13' background rgb 'white'
set output 'accuracy-hanging-64-stretch.svg'
plot 10.3222 with lines dashtype 2 linewidth 1.2 linecolor rgb '#495057' title 'the true motion (tiny steps)', \
  $curve0 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 7 linecolor rgb '#d62728' title 'Jacobi (Kang): odd', \
  $curve1 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#f4a6a6' title 'Jacobi (Kang): even', \
  $curve2 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 9 linecolor rgb '#8c1515' title 'Jacobi (Kang) with tethers', \
  $curve3 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 8 linecolor rgb '#e8590c' title 'Jacobi (Kang) in substeps', \
  $curve4 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 5 linecolor rgb '#f59f00' title 'Chebyshev', \
  $curve5 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 13 linecolor rgb '#b8860b' title 'Conjugate gradients', \
  $curve6 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#74c0fc' title 'Multilevel: one linear solve', \
  $curve7 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 5 linecolor rgb '#0b3d91' title 'Multilevel: Newton passes', \
  $curve8 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 8 linecolor rgb '#15aabf' title 'Multilevel in substeps', \
  $curve9 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 9 linecolor rgb '#2b8a3e' title 'Multilevel: BDF2', \
  $curve10 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 11 linecolor rgb '#74b816' title 'Multilevel: BDF2 in substeps', \
  $curve11 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 4 linecolor rgb '#087f5b' title 'Multilevel: finite elements', \
  $curve12 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 7 linecolor rgb '#9c36b5' title 'XPBD: substeps', \
  $curve13 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#da77f2' title 'XPBD: iterations', \
  $curve14 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 13 linecolor rgb '#e64980' title 'Fibres and sets', \
  $curve15 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 12 linecolor rgb '#f783ac' title 'Fibres and sets in substeps', \
  $curve16 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 15 linecolor rgb '#495057' title 'Symplectic Euler', \
  $curve17 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 14 linecolor rgb '#adb5bd' title 'Explicit Euler', \
  $curve18 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 2 linecolor rgb '#000000' title 'Sparse Cholesky', \
  $default using 1:2 with points pointtype 3 pointsize 3 linewidth 3 linecolor rgb '#000000' title 'Weft''s default'
set terminal pngcairo size 1200,760 font 'DejaVu Sans,10' background rgb 'white'
set output 'accuracy-hanging-64-stretch.png'
plot 10.3222 with lines dashtype 2 linewidth 1.2 linecolor rgb '#495057' title 'the true motion (tiny steps)', \
  $curve0 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 7 linecolor rgb '#d62728' title 'Jacobi (Kang): odd', \
  $curve1 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#f4a6a6' title 'Jacobi (Kang): even', \
  $curve2 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 9 linecolor rgb '#8c1515' title 'Jacobi (Kang) with tethers', \
  $curve3 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 8 linecolor rgb '#e8590c' title 'Jacobi (Kang) in substeps', \
  $curve4 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 5 linecolor rgb '#f59f00' title 'Chebyshev', \
  $curve5 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 13 linecolor rgb '#b8860b' title 'Conjugate gradients', \
  $curve6 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#74c0fc' title 'Multilevel: one linear solve', \
  $curve7 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 5 linecolor rgb '#0b3d91' title 'Multilevel: Newton passes', \
  $curve8 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 8 linecolor rgb '#15aabf' title 'Multilevel in substeps', \
  $curve9 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 9 linecolor rgb '#2b8a3e' title 'Multilevel: BDF2', \
  $curve10 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 11 linecolor rgb '#74b816' title 'Multilevel: BDF2 in substeps', \
  $curve11 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 4 linecolor rgb '#087f5b' title 'Multilevel: finite elements', \
  $curve12 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 7 linecolor rgb '#9c36b5' title 'XPBD: substeps', \
  $curve13 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#da77f2' title 'XPBD: iterations', \
  $curve14 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 13 linecolor rgb '#e64980' title 'Fibres and sets', \
  $curve15 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 12 linecolor rgb '#f783ac' title 'Fibres and sets in substeps', \
  $curve16 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 15 linecolor rgb '#495057' title 'Symplectic Euler', \
  $curve17 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 14 linecolor rgb '#adb5bd' title 'Explicit Euler', \
  $curve18 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 2 linecolor rgb '#000000' title 'Sparse Cholesky', \
  $default using 1:2 with points pointtype 3 pointsize 3 linewidth 3 linecolor rgb '#000000' title 'Weft''s default'
