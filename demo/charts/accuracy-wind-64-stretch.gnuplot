set encoding utf8
set logscale xy
set format '%g'
set border 3 linecolor rgb '#495057'
set tics nomirror
set grid xtics ytics mxtics mytics linetype 1 linewidth 1 linecolor rgb '#dde2e6', linetype 1 linewidth 0.5 linecolor rgb '#eff2f5'
set xrange [0.07:271.626]
set yrange [1.03709:8281.86]
set title 'Hung sheet in wind, 64 × 64 particles: worst stretch of a thread after 1 s' noenhanced font ',13'
set xlabel 'median time of a frame of 1/60 s [ms]'
set ylabel 'worst stretch [%]'
set key outside right top Left reverse samplen 2 spacing 1.25 font ',10' noenhanced
set rmargin 42
set bmargin 8
set label 1 'AMD EPYC; 2 threads, 1 used; commit 3697fc2; κ = 2276; weft_study accuracy, then weft_study plot'."\n".'Not drawn, since they diverged: Explicit Euler substeps=126; Fibres and sets in substeps iterations=1 substeps=4; Fibres and sets iterations=1'."\n".' Jacobi (Kang): even iterations=2' at screen 0.012, screen 0.085 font ',8' textcolor rgb '#6c757d' noenhanced
$curve0 << END
0.1 107.791 "iterations=1"
0.125 158.415 "iterations=3"
0.172 184.265 "iterations=7"
0.265 182.928 "iterations=15"
0.454 120.879 "iterations=31"
0.836 64.7127 "iterations=63"
1.608 22.6632 "iterations=127"
3.16 18.5609 "iterations=255"
END
$curve1 << END
0.182 427.474 "iterations=8"
0.277 457.245 "iterations=16"
0.845 271.404 "iterations=64"
END
$curve2 << END
0.148 10.5205 "iterations=1"
0.21 2.11067 "iterations=7"
0.49 1.48156 "iterations=31"
1.652 1.68668 "iterations=127"
END
$curve3 << END
0.33 133.692 "iterations=7 substeps=2"
0.647 25.3395 "iterations=7 substeps=4"
1.294 34.9643 "iterations=7 substeps=8"
2.608 31.2025 "iterations=7 substeps=16"
END
$curve4 << END
0.139 196.032 "iterations=4"
0.188 106.817 "iterations=8"
0.287 22.5538 "iterations=16"
0.49 32.909 "iterations=32"
0.91 30.6669 "iterations=64"
1.746 29.5389 "iterations=128"
END
$curve5 << END
0.181 194.107 "iterations=4"
0.284 94.8068 "iterations=8"
0.491 21.2315 "iterations=16"
0.916 33.4842 "iterations=32"
1.751 30.253 "iterations=64"
3.441 29.5688 "iterations=128"
END
$curve6 << END
0.232 32.3992 "iterations=1"
0.32 31.0725 "iterations=2"
0.487 29.7138 "iterations=4"
0.804 29.6931 "iterations=8"
END
$curve7 << END
0.354 30.7721 "passes=2 iterations=1"
0.443 29.9865 "passes=2 iterations=2"
0.497 29.9188 "passes=3 iterations=1"
0.573 29.833 "passes=3 iterations=2"
0.603 29.7909 "passes=4 iterations=1"
0.606 30.1291 "passes=2 iterations=4"
0.681 29.8916 "passes=4 iterations=2"
0.725 29.821 "passes=3 iterations=4"
0.781 30.1069 "passes=2 iterations=6"
0.876 29.7954 "passes=4 iterations=4"
0.891 29.8547 "passes=6 iterations=1"
0.909 29.7895 "passes=3 iterations=6"
0.984 29.898 "passes=6 iterations=2"
1.148 29.8953 "passes=8 iterations=1"
1.252 29.945 "passes=8 iterations=2"
END
$curve8 << END
0.454 32.0449 "passes=1 substeps=2"
0.908 30.322 "passes=1 substeps=4"
1.838 29.4523 "passes=1 substeps=8"
3.794 29.1696 "passes=1 substeps=16"
END
$curve9 << END
0.453 32.4995 "passes=2 iterations=2"
0.483 33.0503 "passes=1 iterations=2"
0.582 31.0606 "passes=3 iterations=2"
0.718 29.2831 "passes=4 iterations=2"
0.878 29.6597 "passes=4 iterations=4"
1.166 28.7583 "passes=6 iterations=4"
END
$curve10 << END
1.167 29.9927 "passes=3 substeps=2"
2.377 32.8222 "passes=3 substeps=4"
4.998 32.2537 "passes=3 substeps=8"
END
$curve11 << END
1.127 34.2231 "passes=1 iterations=2"
1.498 33.2597 "passes=2 iterations=2"
1.993 33.1452 "passes=3 iterations=2"
2.466 32.8279 "passes=4 iterations=2"
3.499 32.7646 "passes=6 iterations=2"
END
$curve12 << END
0.216 4994.76 "substeps=1"
0.42 4130.49 "substeps=2"
0.828 2068.54 "substeps=4"
1.667 521.914 "substeps=8"
3.376 197.72 "substeps=16"
6.708 97.6799 "substeps=32"
13.442 57.969 "substeps=64"
END
$curve13 << END
0.348 3762.94 "iterations=4"
0.887 1676.93 "iterations=16"
3.025 365.133 "iterations=64"
END
$curve14 << END
0.36 5176.16 "iterations=4"
0.933 1502.44 "iterations=16"
3.243 381.038 "iterations=64"
END
$curve15 << END
3.468 158.131 "iterations=1 substeps=16"
13.723 46.0642 "iterations=1 substeps=64"
END
$curve16 << END
6.543 31.25 "substeps=126"
10.039 31.1939 "substeps=193"
19.936 31.2237 "substeps=386"
END
$curve17 << END
24.595 36.3608 "substeps=386"
END
$curve18 << END
169.766 29.572 "one factorisation a step"
END
$default << END
0.582 31.0606 "passes=3 iterations=2"
END
set terminal svg size 1200,760 font 'DejaVu Sans,13' background rgb 'white'
set output 'accuracy-wind-64-stretch.svg'
plot 31.2275 with lines dashtype 2 linewidth 1.2 linecolor rgb '#495057' title 'the true motion (tiny steps)', \
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
set output 'accuracy-wind-64-stretch.png'
plot 31.2275 with lines dashtype 2 linewidth 1.2 linecolor rgb '#495057' title 'the true motion (tiny steps)', \
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
