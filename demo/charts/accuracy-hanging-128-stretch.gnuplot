set encoding utf8
set logscale xy
set format '%g'
set border 3 linecolor rgb '#495057'
set tics nomirror
set grid xtics ytics mxtics mytics linetype 1 linewidth 1 linecolor rgb '#dde2e6', linetype 1 linewidth 0.5 linecolor rgb '#eff2f5'
set xrange [0.2471:412.272]
set yrange [1.87283:35020.3]
set title 'Sheet hung by two corners, 128 × 128 particles: worst stretch of a thread after 1 s' noenhanced font ',13'
set xlabel 'median time of a frame of 1/60 s [ms]'
set ylabel 'worst stretch [%]'
set key outside right top Left reverse samplen 2 spacing 1.25 font ',10' noenhanced
set rmargin 42
set bmargin 8
set label 1 'AMD EPYC; 2 threads, 1 used; commit 3697fc2; κ = 9102; weft_study accuracy, then weft_study plot'."\n".'Not drawn, since they diverged: Fibres and sets in substeps iterations=1 substeps=16; Fibres and sets in substeps iterations=1 substeps=4; Fibres and sets iterations=1'."\n".' Fibres and sets iterations=16; Fibres and sets iterations=4; Jacobi (Kang): even iterations=2' at screen 0.012, screen 0.085 font ',8' textcolor rgb '#6c757d' noenhanced
$curve0 << END
0.353 12.4987 "iterations=1"
0.47 27.017 "iterations=3"
0.684 58.6294 "iterations=7"
1.168 126.094 "iterations=15"
2.153 222.987 "iterations=31"
4.108 290.189 "iterations=63"
7.307 380.262 "iterations=127"
14.242 371.284 "iterations=255"
END
$curve1 << END
0.743 2607.55 "iterations=8"
1.248 1988.98 "iterations=16"
4.124 668.321 "iterations=64"
END
$curve2 << END
0.555 2.67547 "iterations=1"
0.877 3.9201 "iterations=7"
2.305 2.99926 "iterations=31"
7.929 2.7052 "iterations=127"
END
$curve3 << END
1.378 222.619 "iterations=7 substeps=2"
2.78 411.656 "iterations=7 substeps=4"
5.391 672.058 "iterations=7 substeps=8"
10.686 84.7073 "iterations=7 substeps=16"
END
$curve4 << END
0.534 92.0355 "iterations=4"
0.765 249.21 "iterations=8"
1.263 394.189 "iterations=16"
2.263 175.387 "iterations=32"
4.177 66.5339 "iterations=64"
8.111 33.0763 "iterations=128"
END
$curve5 << END
0.754 161.107 "iterations=4"
1.245 287.803 "iterations=8"
2.211 379.521 "iterations=16"
4.101 50.2157 "iterations=32"
7.712 41.7851 "iterations=64"
14.943 31.9803 "iterations=128"
END
$curve6 << END
1.366 29.0157 "iterations=1"
2.303 27.9139 "iterations=2"
3.368 26.9237 "iterations=4"
4.949 26.7767 "iterations=8"
END
$curve7 << END
1.851 26.4451 "passes=2 iterations=1"
2.325 28.2352 "passes=2 iterations=2"
2.406 27.8915 "passes=3 iterations=1"
2.973 26.9348 "passes=2 iterations=4"
3.017 27.5415 "passes=3 iterations=2"
3.293 26.7276 "passes=4 iterations=1"
3.67 27.6915 "passes=4 iterations=2"
3.711 26.8772 "passes=3 iterations=4"
3.961 26.6718 "passes=2 iterations=6"
4.449 26.9126 "passes=6 iterations=1"
4.503 27.0096 "passes=3 iterations=6"
4.702 27.016 "passes=4 iterations=4"
5.063 27.5478 "passes=6 iterations=2"
5.672 26.8478 "passes=8 iterations=1"
6.166 27.4576 "passes=8 iterations=2"
END
$curve8 << END
3.244 29.676 "passes=1 substeps=2"
5.974 33.5801 "passes=1 substeps=4"
12.333 33.1172 "passes=1 substeps=8"
23.413 30.7796 "passes=1 substeps=16"
END
$curve9 << END
2.709 31.9119 "passes=1 iterations=2"
2.73 24.3344 "passes=2 iterations=2"
3.15 15.1697 "passes=3 iterations=2"
3.63 11.3437 "passes=4 iterations=2"
4.375 9.95721 "passes=4 iterations=4"
5.667 8.72139 "passes=6 iterations=4"
END
$curve10 << END
6.349 13.1765 "passes=3 substeps=2"
12.421 18.682 "passes=3 substeps=4"
24.122 14.9279 "passes=3 substeps=8"
END
$curve11 << END
10.339 29.2881 "passes=2 iterations=2"
10.617 34.2309 "passes=1 iterations=2"
13.255 28.317 "passes=3 iterations=2"
17.696 28.2542 "passes=4 iterations=2"
23.714 29.1332 "passes=6 iterations=2"
END
$curve12 << END
0.827 21887.7 "substeps=1"
1.674 18267.2 "substeps=2"
3.392 13174.5 "substeps=4"
6.746 6170.05 "substeps=8"
13.364 690.481 "substeps=16"
26.546 160.439 "substeps=32"
53.248 36.5121 "substeps=64"
END
$curve13 << END
1.465 18631.7 "iterations=4"
3.835 13255.3 "iterations=16"
12.654 5277.02 "iterations=64"
END
$curve14 << END
13.033 3686.27 "iterations=64"
END
$curve15 << END
56.584 30.1719 "iterations=1 substeps=64"
END
$curve16 << END
58.971 16.0669 "substeps=404"
107.458 14.915 "substeps=622"
201.638 15.7813 "substeps=1243"
END
$curve17 << END
79.677 14.7649 "substeps=404"
257.67 16.0722 "substeps=1243"
END
$default << END
3.15 15.1697 "passes=3 iterations=2"
END
set terminal svg size 1200,760 font 'DejaVu Sans,13' background rgb 'white'
set output 'accuracy-hanging-128-stretch.svg'
plot 14.4691 with lines dashtype 2 linewidth 1.2 linecolor rgb '#495057' title 'the true motion (tiny steps)', \
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
set output 'accuracy-hanging-128-stretch.png'
plot 14.4691 with lines dashtype 2 linewidth 1.2 linecolor rgb '#495057' title 'the true motion (tiny steps)', \
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
