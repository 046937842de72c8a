set encoding utf8
set logscale xy
set format '%g'
set border 3 linecolor rgb '#495057'
set tics nomirror
set grid xtics ytics mxtics mytics linetype 1 linewidth 1 linecolor rgb '#dde2e6', linetype 1 linewidth 0.5 linecolor rgb '#eff2f5'
set xrange [0.969255:127.632]
set yrange [4.80124:1498.02]
set title 'Sheet hung by two corners, 256 × 256 particles: distance from the true motion (tiny steps) after 0.5 s' noenhanced font ',13'
set xlabel 'median time of a frame of 1/60 s [ms]'
set ylabel 'RMS distance of particles [mm]'
set key outside right top Left reverse samplen 2 spacing 1.25 font ',10' noenhanced
set rmargin 42
set bmargin 8
set label 1 'Intel(R) Xeon(R) Processor; 2 threads, 2 used; commit 626c968+; κ = 36409; weft_study accuracy, then weft_study plot'."\n".'Not drawn, since they diverged: Fibres and sets in substeps iterations=1 substeps=16; Fibres and sets in substeps iterations=1 substeps=4; Fibres and sets iterations=1'."\n".' Fibres and sets iterations=16; Fibres and sets iterations=4; Fibres and sets iterations=64' at screen 0.012, screen 0.085 font ',8' textcolor rgb '#6c757d' noenhanced
$front << END
1.38465 936.261 "substeps=1"
1.60157 744.423 "iterations=1"
2.05668 726.199 "iterations=3"
2.68719 720.619 "iterations=4"
3.00878 708.813 "iterations=7"
3.01666 702.559 "iterations=8"
4.09369 67.5208 "iterations=1"
5.50249 49.1019 "iterations=2"
5.70723 39.0943 "passes=1 iterations=2"
7.69578 33.9471 "passes=1 substeps=2"
7.77169 24.7476 "passes=2 iterations=2"
10.1821 19.0842 "passes=3 iterations=2"
19.7516 13.7565 "passes=3 substeps=2"
39.0259 8.16707 "passes=3 substeps=4"
78.591 6.85892 "passes=3 substeps=8"
END
$curve0 << END
1.60157 744.423 "iterations=1"
2.05668 726.199 "iterations=3"
3.00878 708.813 "iterations=7"
4.9116 685.12 "iterations=15"
8.13761 661.301 "iterations=31"
15.9449 640.317 "iterations=63"
28.9889 618.169 "iterations=127"
60.1305 601.944 "iterations=255"
END
$curve1 << END
1.68607 762.694 "iterations=2"
3.01666 702.559 "iterations=8"
4.81886 679.286 "iterations=16"
15.2838 637.192 "iterations=64"
END
$curve2 << END
2.16107 745.947 "iterations=1"
3.54933 707.235 "iterations=7"
8.37679 596.213 "iterations=31"
28.4986 532.588 "iterations=127"
END
$curve3 << END
5.50856 664.855 "iterations=7 substeps=2"
10.8149 615.604 "iterations=7 substeps=4"
21.3717 585.618 "iterations=7 substeps=8"
43.1197 499.148 "iterations=7 substeps=16"
END
$curve4 << END
2.3426 747.049 "iterations=4"
3.12025 728.695 "iterations=8"
4.97578 696.591 "iterations=16"
8.85925 654.983 "iterations=32"
15.5253 562.092 "iterations=64"
30.13 409.021 "iterations=128"
END
$curve5 << END
2.68719 720.619 "iterations=4"
4.36625 694.75 "iterations=8"
7.48366 652.123 "iterations=16"
14.038 599.394 "iterations=32"
27.6239 531.341 "iterations=64"
54.6689 374.608 "iterations=128"
END
$curve6 << END
5.06269 108.025 "iterations=1"
7.6397 98.5087 "iterations=2"
9.93413 65.2633 "iterations=3"
12.2241 59.7568 "iterations=4"
16.6832 67.7344 "iterations=6"
21.8559 77.7007 "iterations=8"
30.6911 82.9486 "iterations=12"
39.4223 79.4883 "iterations=16"
END
$curve7 << END
4.09369 67.5208 "iterations=1"
5.50249 49.1019 "iterations=2"
9.29893 51.5461 "iterations=4"
13.8963 237.201 "iterations=8"
END
$curve8 << END
6.18065 54.852 "passes=2 iterations=1"
7.64275 42.5845 "passes=2 iterations=2"
8.32298 35.421 "passes=3 iterations=1"
9.82728 34.1651 "passes=3 iterations=2"
10.4451 38.0567 "passes=4 iterations=1"
10.5967 41.426 "passes=2 iterations=4"
11.8479 38.2963 "passes=4 iterations=2"
12.7991 37.6776 "passes=3 iterations=4"
13.3542 40.1197 "passes=2 iterations=6"
14.7757 35.4541 "passes=4 iterations=4"
15.1221 37.5864 "passes=6 iterations=1"
15.6459 38.0687 "passes=3 iterations=6"
16.592 35.9529 "passes=6 iterations=2"
19.443 35.8726 "passes=8 iterations=1"
20.4397 34.8993 "passes=8 iterations=2"
END
$curve9 << END
7.69578 33.9471 "passes=1 substeps=2"
14.9449 26.3714 "passes=1 substeps=4"
30.2282 20.9937 "passes=1 substeps=8"
60.5766 17.3983 "passes=1 substeps=16"
END
$curve10 << END
5.70723 39.0943 "passes=1 iterations=2"
7.77169 24.7476 "passes=2 iterations=2"
10.1821 19.0842 "passes=3 iterations=2"
12.1162 22.7208 "passes=4 iterations=2"
14.9937 20.4512 "passes=4 iterations=4"
19.5325 23.6961 "passes=6 iterations=4"
END
$curve11 << END
19.7516 13.7565 "passes=3 substeps=2"
39.0259 8.16707 "passes=3 substeps=4"
78.591 6.85892 "passes=3 substeps=8"
END
$curve12 << END
1.38465 936.261 "substeps=1"
2.01047 913.749 "substeps=2"
3.79671 881.918 "substeps=4"
7.53775 809.937 "substeps=8"
14.743 662.419 "substeps=16"
29.5906 441.146 "substeps=32"
58.2467 228.209 "substeps=64"
END
$curve13 << END
3.01893 925.765 "iterations=4"
10.6864 895.18 "iterations=16"
40.9575 807.649 "iterations=64"
END
$curve14 << END
79.7699 139.582 "iterations=1 substeps=64"
END
$default << END
9.82728 34.1651 "passes=3 iterations=2"
END
set terminal svg size 1200,760 font 'DejaVu Sans,13' background rgb 'white'
set output 'accuracy-hanging-256-b-0.5s.svg'
plot $front using 1:2 with lines linewidth 9 linecolor rgb '#ffe8a3' title 'the front: nothing is cheaper and better', \
  38.0331 with lines dashtype 2 linewidth 1.2 linecolor rgb '#495057' title 'backward Euler, converged', \
  19.6293 with lines dashtype 3 linewidth 1.2 linecolor rgb '#495057' title 'BDF2, converged', \
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
  $curve12 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 7 linecolor rgb '#9c36b5' title 'XPBD: substeps', \
  $curve13 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#da77f2' title 'XPBD: iterations', \
  $curve14 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 12 linecolor rgb '#f783ac' title 'Fibres and sets in substeps', \
  $front using 1:2:3 with labels left offset 0.8,0.6 font ',7' textcolor rgb '#343a40' noenhanced notitle, \
  $default using 1:2 with points pointtype 3 pointsize 3 linewidth 3 linecolor rgb '#000000' title 'Weft''s default'
set terminal pngcairo size 1200,760 font 'DejaVu Sans,10' background rgb 'white'
set output 'accuracy-hanging-256-b-0.5s.png'
plot $front using 1:2 with lines linewidth 9 linecolor rgb '#ffe8a3' title 'the front: nothing is cheaper and better', \
  38.0331 with lines dashtype 2 linewidth 1.2 linecolor rgb '#495057' title 'backward Euler, converged', \
  19.6293 with lines dashtype 3 linewidth 1.2 linecolor rgb '#495057' title 'BDF2, converged', \
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
  $curve12 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 7 linecolor rgb '#9c36b5' title 'XPBD: substeps', \
  $curve13 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#da77f2' title 'XPBD: iterations', \
  $curve14 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 12 linecolor rgb '#f783ac' title 'Fibres and sets in substeps', \
  $front using 1:2:3 with labels left offset 0.8,0.6 font ',7' textcolor rgb '#343a40' noenhanced notitle, \
  $default using 1:2 with points pointtype 3 pointsize 3 linewidth 3 linecolor rgb '#000000' title 'Weft''s default'
