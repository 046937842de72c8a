set encoding utf8
set logscale xy
set format '%g'
set border 3 linecolor rgb '#495057'
set tics nomirror
set grid xtics ytics mxtics mytics linetype 1 linewidth 1 linecolor rgb '#dde2e6', linetype 1 linewidth 0.5 linecolor rgb '#eff2f5'
set xrange [0.2947:508.909]
set yrange [1.24611:16717.6]
set title 'Hung sheet in wind, 128 × 128 particles: worst stretch of a thread after 1 s' noenhanced font ',13'
set xlabel 'median time of a frame of 1/60 s [ms]'
set ylabel 'worst stretch [%]'
set key outside right top Left reverse samplen 2 spacing 1.25 font ',10' noenhanced
set rmargin 42
set bmargin 8
set label 1 'AMD EPYC; 2 threads, 1 used; commit 3697fc2; κ = 9102; weft_study accuracy, then weft_study plot'."\n".'Not drawn, since they diverged: Fibres and sets in substeps iterations=1 substeps=4; Fibres and sets iterations=1; Fibres and sets iterations=4'."\n".' Jacobi (Kang): even iterations=2' at screen 0.012, screen 0.085 font ',8' textcolor rgb '#6c757d' noenhanced
$curve0 << END
0.421 12.2904 "iterations=1"
0.539 26.1003 "iterations=3"
0.818 55.0243 "iterations=7"
1.36 112.287 "iterations=15"
2.301 183.139 "iterations=31"
4.299 245.429 "iterations=63"
8.301 231.891 "iterations=127"
16.198 146.093 "iterations=255"
END
$curve1 << END
0.857 2322.83 "iterations=8"
1.376 2061.47 "iterations=16"
4.453 471.049 "iterations=64"
END
$curve2 << END
0.636 2.55117 "iterations=1"
0.982 3.63138 "iterations=7"
2.485 1.78016 "iterations=31"
8.394 4.18604 "iterations=127"
END
$curve3 << END
1.554 184.501 "iterations=7 substeps=2"
3.085 260.053 "iterations=7 substeps=4"
6.357 64.2165 "iterations=7 substeps=8"
12.726 49.6442 "iterations=7 substeps=16"
END
$curve4 << END
0.651 84.6677 "iterations=4"
0.903 207.943 "iterations=8"
1.386 232.831 "iterations=16"
2.474 46.5719 "iterations=32"
4.555 56.4199 "iterations=64"
8.701 55.2168 "iterations=128"
END
$curve5 << END
0.778 125.238 "iterations=4"
1.26 237.8 "iterations=8"
2.296 200.985 "iterations=16"
4.204 39.1216 "iterations=32"
7.855 61.7394 "iterations=64"
15.152 56.4014 "iterations=128"
END
$curve6 << END
1.336 59.0377 "iterations=1"
1.53 61.1235 "iterations=2"
2.342 56.7254 "iterations=4"
4.037 55.9074 "iterations=8"
END
$curve7 << END
1.759 61.9869 "passes=2 iterations=1"
2.314 58.2791 "passes=2 iterations=2"
2.679 59.3667 "passes=3 iterations=1"
2.901 56.3767 "passes=2 iterations=4"
3.095 56.1068 "passes=3 iterations=2"
3.248 56.4503 "passes=4 iterations=1"
3.951 56.1902 "passes=3 iterations=4"
4.003 55.8258 "passes=4 iterations=2"
4.025 56.5454 "passes=2 iterations=6"
4.803 56.0154 "passes=4 iterations=4"
4.944 56.252 "passes=3 iterations=6"
5.057 55.7414 "passes=6 iterations=2"
5.08 55.9528 "passes=6 iterations=1"
6.149 55.7733 "passes=8 iterations=1"
6.338 55.6805 "passes=8 iterations=2"
END
$curve8 << END
3.276 58.9964 "passes=1 substeps=2"
6.935 68.6953 "passes=1 substeps=4"
12.691 67.0394 "passes=1 substeps=8"
20.686 64.3818 "passes=1 substeps=16"
END
$curve9 << END
2.658 62.303 "passes=1 iterations=2"
3.163 56.7424 "passes=2 iterations=2"
3.832 58.7959 "passes=3 iterations=2"
4.157 53.7603 "passes=4 iterations=2"
5.042 53.4194 "passes=4 iterations=4"
6.236 53.4941 "passes=6 iterations=4"
END
$curve10 << END
7.121 56.6613 "passes=3 substeps=2"
14.679 66.2045 "passes=3 substeps=4"
29.653 63.2817 "passes=3 substeps=8"
END
$curve11 << END
7.395 68.4064 "passes=1 iterations=2"
11.856 64.5147 "passes=2 iterations=2"
15.543 65.29 "passes=3 iterations=2"
17.718 65.5969 "passes=4 iterations=2"
24.115 65.3515 "passes=6 iterations=2"
END
$curve12 << END
0.872 10448.5 "substeps=1"
1.722 9564.24 "substeps=2"
3.44 7960.4 "substeps=4"
6.909 4385.6 "substeps=8"
13.8 1068.49 "substeps=16"
27.332 469.465 "substeps=32"
54.053 223.78 "substeps=64"
END
$curve13 << END
1.434 8710.59 "iterations=4"
3.742 6875.49 "iterations=16"
12.404 3379.23 "iterations=64"
END
$curve14 << END
3.702 8768.26 "iterations=16"
12.553 3697.37 "iterations=64"
END
$curve15 << END
13.751 1220.34 "iterations=1 substeps=16"
54.642 162.504 "iterations=1 substeps=64"
END
$curve16 << END
89.578 61.6149 "substeps=404"
139.069 61.606 "substeps=622"
275.787 61.5831 "substeps=1243"
END
$curve17 << END
104.272 59.366 "substeps=404"
318.068 61.6905 "substeps=1243"
END
$default << END
3.832 58.7959 "passes=3 iterations=2"
END
set terminal svg size 1200,760 font 'DejaVu Sans,13' background rgb 'white'
set output 'accuracy-wind-128-stretch.svg'
plot 61.6098 with lines dashtype 2 linewidth 1.2 linecolor rgb '#495057' title 'the true motion (tiny steps)', \
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
  $default using 1:2 with points pointtype 3 pointsize 3 linewidth 3 linecolor rgb '#000000' title 'Weft''s default'
set terminal pngcairo size 1200,760 font 'DejaVu Sans,10' background rgb 'white'
set output 'accuracy-wind-128-stretch.png'
plot 61.6098 with lines dashtype 2 linewidth 1.2 linecolor rgb '#495057' title 'the true motion (tiny steps)', \
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
  $default using 1:2 with points pointtype 3 pointsize 3 linewidth 3 linecolor rgb '#000000' title 'Weft''s default'
