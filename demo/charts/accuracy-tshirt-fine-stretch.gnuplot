set encoding utf8
set logscale xy
set format '%g'
set border 3 linecolor rgb '#495057'
set tics nomirror
set grid xtics ytics mxtics mytics linetype 1 linewidth 1 linecolor rgb '#dde2e6', linetype 1 linewidth 0.5 linecolor rgb '#eff2f5'
set xrange [0.299466:3154.11]
set yrange [7.51562:1651.58]
set title 'T-shirt hung by its neck, 14048 particles: worst stretch of a thread after 1 s' noenhanced font ',13'
set xlabel 'median time of a frame of 1/60 s [ms]'
set ylabel 'worst stretch [%]'
set key outside right top Left reverse samplen 2 spacing 1.25 font ',10' noenhanced
set rmargin 42
set bmargin 5
set label 1 'Intel(R) Xeon(R) Processor; 2 threads, 2 used; commit 05b8bef; κ = 11579; weft_study accuracy, then weft_study plot' at screen 0.012, screen 0.022 font ',8' textcolor rgb '#6c757d' noenhanced
$curve0 << END
0.489107 600.43 "iterations=1"
0.641293 621.113 "iterations=3"
0.915619 430.228 "iterations=7"
1.53938 173.399 "iterations=15"
2.83656 134.266 "iterations=31"
5.5023 121.519 "iterations=63"
9.91574 115.724 "iterations=127"
18.9936 105.183 "iterations=255"
END
$curve1 << END
0.553868 1032.24 "iterations=2"
1.07029 447.767 "iterations=8"
1.99418 204.012 "iterations=16"
5.67879 121.016 "iterations=64"
END
$curve2 << END
0.494642 600.43 "iterations=1"
0.942846 430.228 "iterations=7"
2.6474 134.266 "iterations=31"
8.27577 115.724 "iterations=127"
END
$curve3 << END
1.50371 41.5149 "iterations=7 substeps=2"
2.9336 10.7464 "iterations=7 substeps=4"
6.74113 10.8035 "iterations=7 substeps=8"
13.2928 10.8498 "iterations=7 substeps=16"
END
$curve4 << END
0.591996 257.048 "iterations=4"
0.86306 216.945 "iterations=8"
1.47748 174.699 "iterations=16"
2.77239 80.8116 "iterations=32"
5.45302 68.2236 "iterations=64"
10.8697 62.4286 "iterations=128"
END
$curve5 << END
0.90104 711.17 "iterations=4"
1.34957 350.864 "iterations=8"
2.41302 129.044 "iterations=16"
4.41327 62.4431 "iterations=32"
8.00856 34.8481 "iterations=64"
15.2209 36.6791 "iterations=128"
END
$curve6 << END
1.24227 12.7959 "iterations=1"
2.37013 12.4591 "iterations=2"
3.01387 55.7783 "iterations=3"
3.49988 17.6105 "iterations=4"
5.25872 12.6782 "iterations=6"
6.77402 10.7801 "iterations=8"
9.36239 10.7559 "iterations=12"
11.7111 10.7709 "iterations=16"
END
$curve7 << END
1.09435 12.7959 "iterations=1"
1.42744 10.7871 "iterations=2"
2.10588 10.7952 "iterations=4"
3.60014 10.814 "iterations=8"
END
$curve8 << END
1.88948 10.8029 "passes=2 iterations=1"
1.9389 10.7754 "passes=2 iterations=2"
2.01758 10.7829 "passes=3 iterations=1"
2.53353 10.8319 "passes=2 iterations=4"
2.5868 10.7509 "passes=3 iterations=2"
2.58747 10.7565 "passes=4 iterations=1"
3.2371 10.7676 "passes=4 iterations=2"
3.79569 10.7974 "passes=3 iterations=6"
3.85421 10.8336 "passes=3 iterations=4"
4.02388 10.7972 "passes=2 iterations=6"
4.6169 10.8088 "passes=4 iterations=4"
5.0354 10.7709 "passes=6 iterations=1"
5.13796 10.7779 "passes=8 iterations=1"
5.47684 29.4897 "passes=8 iterations=2"
6.31252 10.7897 "passes=6 iterations=2"
END
$curve9 << END
2.8133 10.8491 "passes=1 substeps=2"
3.93791 10.7874 "passes=1 substeps=4"
7.58013 10.784 "passes=1 substeps=8"
14.9019 10.806 "passes=1 substeps=16"
END
$curve10 << END
0.427809 80.7505 "substeps=1"
0.755987 63.2221 "substeps=2"
1.10567 53.4144 "substeps=4"
2.13677 45.3555 "substeps=8"
4.12125 47.917 "substeps=16"
9.09258 36.384 "substeps=32"
15.5905 27.0799 "substeps=64"
END
$curve11 << END
0.840963 58.7689 "iterations=4"
3.10746 51.7298 "iterations=16"
12.1117 45.6018 "iterations=64"
END
$curve12 << END
0.866309 215.735 "iterations=1"
2.76879 89.6039 "iterations=4"
10.7673 72.2699 "iterations=16"
42.3809 39.234 "iterations=64"
END
$curve13 << END
3.09443 56.9953 "iterations=1 substeps=4"
12.1172 29.8677 "iterations=1 substeps=16"
48.6219 22.5605 "iterations=1 substeps=64"
END
$curve14 << END
538.31 10.7985 "substeps=3040"
818.553 10.7789 "substeps=4677"
1864.35 10.7368 "substeps=9353"
END
$curve15 << END
622.884 10.8005 "substeps=3040"
1971.32 10.7366 "substeps=9353"
END
$default << END
2.5868 10.7509 "passes=3 iterations=2"
END
set terminal svg size 1200,760 font 'DejaVu Sans,13' background rgb 'white'
set output 'accuracy-tshirt-fine-stretch.svg'
plot $curve0 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 7 linecolor rgb '#d62728' title 'Jacobi (Kang): odd', \
  $curve1 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#f4a6a6' title 'Jacobi (Kang): even', \
  $curve2 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 9 linecolor rgb '#8c1515' title 'Jacobi (Kang) with tethers', \
  $curve3 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 8 linecolor rgb '#e8590c' title 'Jacobi (Kang) in substeps', \
  $curve4 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 5 linecolor rgb '#f59f00' title 'Chebyshev', \
  $curve5 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 13 linecolor rgb '#b8860b' title 'Conjugate gradients', \
  $curve6 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 7 linecolor rgb '#1f77b4' title 'Multilevel: nonlinear CG', \
  $curve7 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#74c0fc' title 'Multilevel: one linear solve', \
  $curve8 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 5 linecolor rgb '#0b3d91' title 'Multilevel: Newton passes', \
  $curve9 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 8 linecolor rgb '#15aabf' title 'Multilevel in substeps', \
  $curve10 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 7 linecolor rgb '#9c36b5' title 'XPBD: substeps', \
  $curve11 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#da77f2' title 'XPBD: iterations', \
  $curve12 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 13 linecolor rgb '#e64980' title 'Fibres and sets', \
  $curve13 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 12 linecolor rgb '#f783ac' title 'Fibres and sets in substeps', \
  $curve14 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 15 linecolor rgb '#495057' title 'Symplectic Euler', \
  $curve15 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 14 linecolor rgb '#adb5bd' title 'Explicit Euler', \
  $default using 1:2 with points pointtype 3 pointsize 3 linewidth 3 linecolor rgb '#000000' title 'Weft''s default'
set terminal pngcairo size 1200,760 font 'DejaVu Sans,10' background rgb 'white'
set output 'accuracy-tshirt-fine-stretch.png'
plot $curve0 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 7 linecolor rgb '#d62728' title 'Jacobi (Kang): odd', \
  $curve1 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#f4a6a6' title 'Jacobi (Kang): even', \
  $curve2 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 9 linecolor rgb '#8c1515' title 'Jacobi (Kang) with tethers', \
  $curve3 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 8 linecolor rgb '#e8590c' title 'Jacobi (Kang) in substeps', \
  $curve4 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 5 linecolor rgb '#f59f00' title 'Chebyshev', \
  $curve5 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 13 linecolor rgb '#b8860b' title 'Conjugate gradients', \
  $curve6 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 7 linecolor rgb '#1f77b4' title 'Multilevel: nonlinear CG', \
  $curve7 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#74c0fc' title 'Multilevel: one linear solve', \
  $curve8 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 5 linecolor rgb '#0b3d91' title 'Multilevel: Newton passes', \
  $curve9 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 8 linecolor rgb '#15aabf' title 'Multilevel in substeps', \
  $curve10 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 7 linecolor rgb '#9c36b5' title 'XPBD: substeps', \
  $curve11 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#da77f2' title 'XPBD: iterations', \
  $curve12 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 13 linecolor rgb '#e64980' title 'Fibres and sets', \
  $curve13 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 12 linecolor rgb '#f783ac' title 'Fibres and sets in substeps', \
  $curve14 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 15 linecolor rgb '#495057' title 'Symplectic Euler', \
  $curve15 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 14 linecolor rgb '#adb5bd' title 'Explicit Euler', \
  $default using 1:2 with points pointtype 3 pointsize 3 linewidth 3 linecolor rgb '#000000' title 'Weft''s default'
