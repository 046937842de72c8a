set encoding utf8
set logscale xy
set format '%g'
set border 3 linecolor rgb '#495057'
set tics nomirror
set grid xtics ytics mxtics mytics linetype 1 linewidth 1 linecolor rgb '#dde2e6', linetype 1 linewidth 0.5 linecolor rgb '#eff2f5'
set xrange [0.0483:242.042]
set yrange [2.59936:16301.3]
set title 'Sheet hung by two corners, 64 × 64 particles: worst stretch of a thread after 1 s' noenhanced font ',13'
set xlabel 'median time of a frame of 1/60 s [ms]'
set ylabel 'worst stretch [%]'
set key outside right top Left reverse samplen 2 spacing 1.25 font ',10' noenhanced
set rmargin 42
set bmargin 8
set label 1 'Intel(R) Xeon(R) Processor; 2 threads, 1 used; commit 12ab06f; κ = 2276; weft_study accuracy, then weft_study plot'."\n".'Not drawn, since they diverged: Explicit Euler substeps=126; Fibres and sets in substeps iterations=1 substeps=4; Fibres and sets iterations=1'."\n".' Fibres and sets iterations=4; Jacobi (Kang): even iterations=2' at screen 0.012, screen 0.085 font ',8' textcolor rgb '#6c757d' noenhanced
$curve0 << END
0.069 125.305 "iterations=1"
0.094 206.024 "iterations=3"
0.14 242.182 "iterations=7"
0.233 269.342 "iterations=15"
0.413 321.76 "iterations=31"
0.77 164.361 "iterations=63"
1.483 77.6017 "iterations=127"
2.957 54.9313 "iterations=255"
END
$curve1 << END
0.144 490.462 "iterations=8"
0.233 490.953 "iterations=16"
0.788 173.129 "iterations=64"
END
$curve2 << END
0.106 4.02412 "iterations=1"
0.181 4.62357 "iterations=7"
0.446 3.71337 "iterations=31"
1.507 4.73926 "iterations=127"
END
$curve3 << END
0.26 302.287 "iterations=7 substeps=2"
0.528 302.699 "iterations=7 substeps=4"
1.024 5.50229 "iterations=7 substeps=8"
2.007 21.5532 "iterations=7 substeps=16"
END
$curve4 << END
0.107 266.374 "iterations=4"
0.151 357.402 "iterations=8"
0.242 180.391 "iterations=16"
0.423 28.9473 "iterations=32"
0.79 15.4212 "iterations=64"
1.495 14.3549 "iterations=128"
END
$curve5 << END
0.147 272.939 "iterations=4"
0.243 252.905 "iterations=8"
0.434 71.0854 "iterations=16"
0.812 27.5134 "iterations=32"
1.703 16.3329 "iterations=64"
3.334 13.8947 "iterations=128"
END
$curve6 << END
0.413 14.2791 "passes=2"
0.431 14.4308 "passes=1"
0.543 15.3063 "passes=3"
0.707 14.9756 "passes=4"
0.996 14.8025 "passes=6"
1.254 14.7521 "passes=8"
1.865 14.6877 "passes=12"
2.666 14.6274 "passes=18"
END
$curve7 << END
0.796 16.6597 "passes=1 substeps=2"
1.624 14.756 "passes=1 substeps=4"
3.207 15.2686 "passes=1 substeps=8"
6.478 13.8952 "passes=1 substeps=16"
END
$curve8 << END
0.548 8.60861 "passes=2"
0.558 11.3663 "passes=1"
0.588 9.77198 "passes=3"
0.737 6.54085 "passes=4"
0.991 5.11658 "passes=6"
1.271 6.59606 "passes=8"
1.841 7.06371 "passes=12"
END
$curve9 << END
0.975 10.6753 "passes=1 substeps=2"
1.112 7.60444 "passes=3 substeps=2"
2.174 10.9789 "passes=1 substeps=4"
2.202 9.65808 "passes=3 substeps=4"
4.041 11.1218 "passes=1 substeps=8"
4.51 11.5738 "passes=3 substeps=8"
END
$curve10 << END
1.562 17.8267 "passes=1"
1.597 17.679 "passes=2"
2.162 14.9437 "passes=3"
2.702 15.2638 "passes=4"
3.837 15.0326 "passes=6"
END
$curve11 << END
0.173 10188.3 "substeps=1"
0.334 6969.2 "substeps=2"
0.668 2672.14 "substeps=4"
1.304 284.281 "substeps=8"
2.583 41.2432 "substeps=16"
5.19 12.2388 "substeps=32"
10.394 6.81458 "substeps=64"
END
$curve12 << END
0.279 7019.07 "iterations=4"
0.743 2375.11 "iterations=16"
2.47 233.265 "iterations=64"
END
$curve13 << END
0.83 1589.04 "iterations=16"
2.987 155.132 "iterations=64"
END
$curve14 << END
2.748 30.3117 "iterations=1 substeps=16"
11.068 9.12699 "iterations=1 substeps=64"
END
$curve15 << END
3.869 9.40889 "substeps=126"
5.87 8.47964 "substeps=193"
11.587 9.7979 "substeps=386"
END
$curve16 << END
15.456 10.8882 "substeps=386"
END
$curve17 << END
151.276 14.2967 "one factorisation a step"
END
$default << END
0.588 9.77198 "passes=3"
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
  $curve6 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 5 linecolor rgb '#0b3d91' title 'Multilevel: Newton passes', \
  $curve7 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 8 linecolor rgb '#15aabf' title 'Multilevel in substeps', \
  $curve8 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 9 linecolor rgb '#2b8a3e' title 'Multilevel: BDF2', \
  $curve9 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 11 linecolor rgb '#74b816' title 'Multilevel: BDF2 in substeps', \
  $curve10 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 4 linecolor rgb '#087f5b' title 'Multilevel: finite elements', \
  $curve11 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 7 linecolor rgb '#9c36b5' title 'XPBD: substeps', \
  $curve12 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#da77f2' title 'XPBD: iterations', \
  $curve13 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 13 linecolor rgb '#e64980' title 'Fibres and sets', \
  $curve14 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 12 linecolor rgb '#f783ac' title 'Fibres and sets in substeps', \
  $curve15 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 15 linecolor rgb '#495057' title 'Symplectic Euler', \
  $curve16 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 14 linecolor rgb '#adb5bd' title 'Explicit Euler', \
  $curve17 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 2 linecolor rgb '#000000' title 'Sparse Cholesky', \
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
  $curve6 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 5 linecolor rgb '#0b3d91' title 'Multilevel: Newton passes', \
  $curve7 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 8 linecolor rgb '#15aabf' title 'Multilevel in substeps', \
  $curve8 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 9 linecolor rgb '#2b8a3e' title 'Multilevel: BDF2', \
  $curve9 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 11 linecolor rgb '#74b816' title 'Multilevel: BDF2 in substeps', \
  $curve10 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 4 linecolor rgb '#087f5b' title 'Multilevel: finite elements', \
  $curve11 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 7 linecolor rgb '#9c36b5' title 'XPBD: substeps', \
  $curve12 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#da77f2' title 'XPBD: iterations', \
  $curve13 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 13 linecolor rgb '#e64980' title 'Fibres and sets', \
  $curve14 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 12 linecolor rgb '#f783ac' title 'Fibres and sets in substeps', \
  $curve15 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 15 linecolor rgb '#495057' title 'Symplectic Euler', \
  $curve16 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 14 linecolor rgb '#adb5bd' title 'Explicit Euler', \
  $curve17 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 2 linecolor rgb '#000000' title 'Sparse Cholesky', \
  $default using 1:2 with points pointtype 3 pointsize 3 linewidth 3 linecolor rgb '#000000' title 'Weft''s default'
