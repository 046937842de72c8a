set encoding utf8
set logscale xy
set format '%g'
set border 3 linecolor rgb '#495057'
set tics nomirror
set grid xtics ytics mxtics mytics linetype 1 linewidth 1 linecolor rgb '#dde2e6', linetype 1 linewidth 0.5 linecolor rgb '#eff2f5'
set xrange [0.289804:863.368]
set yrange [2.19134:6883.15]
set title 'Sheet hung by two corners, 128 × 128 particles: distance from converged backward Euler after 1 s' noenhanced font ',13'
set xlabel 'median time of a frame of 1/60 s [ms]'
set ylabel 'RMS distance of particles [mm]'
set key outside right top Left reverse samplen 2 spacing 1.25 font ',10' noenhanced
set rmargin 42
set bmargin 8
set label 1 'Intel(R) Xeon(R) Processor; 2 threads, 2 used; commit 05b8bef; κ = 9102; weft_study accuracy, then weft_study plot'."\n".'Not drawn, since they diverged: Fibres and sets in substeps iterations=1 substeps=4; Fibres and sets iterations=1; Fibres and sets iterations=4' at screen 0.012, screen 0.085 font ',8' textcolor rgb '#6c757d' noenhanced
$front << END
0.414006 4301.97 "substeps=1"
0.465065 1089.74 "iterations=1"
0.59482 983.613 "iterations=1"
0.913963 846.164 "iterations=7"
1.15741 113.681 "iterations=1"
1.60397 42.908 "iterations=2"
1.8752 35.6642 "passes=2 iterations=1"
2.46583 17.5854 "passes=2 iterations=2"
2.94979 9.97224 "passes=3 iterations=2"
3.19455 7.87578 "passes=2 iterations=4"
3.48598 7.21681 "passes=4 iterations=2"
3.93078 6.95032 "passes=3 iterations=4"
4.15695 5.92657 "passes=2 iterations=6"
4.22556 4.87534 "passes=4 iterations=4"
4.781 3.13049 "passes=3 iterations=6"
END
$curve0 << END
0.465065 1089.74 "iterations=1"
0.591411 1108.76 "iterations=3"
0.852744 1149.57 "iterations=7"
1.23069 1166.74 "iterations=15"
2.048 1165.68 "iterations=31"
3.60433 1136.28 "iterations=63"
7.21014 998.678 "iterations=127"
14.4253 828.154 "iterations=255"
END
$curve1 << END
0.502672 1151.85 "iterations=2"
0.833343 1163.39 "iterations=8"
1.27275 1178.93 "iterations=16"
4.04322 1123.37 "iterations=64"
END
$curve2 << END
0.59482 983.613 "iterations=1"
0.913963 846.164 "iterations=7"
2.32295 729.333 "iterations=31"
7.78924 617.403 "iterations=127"
END
$curve3 << END
1.76172 1153.69 "iterations=7 substeps=2"
3.50398 967.454 "iterations=7 substeps=4"
6.21934 505.234 "iterations=7 substeps=8"
12.4877 138.53 "iterations=7 substeps=16"
END
$curve4 << END
0.649131 1088.36 "iterations=4"
0.908507 1066.91 "iterations=8"
1.44532 951.486 "iterations=16"
2.35863 690.353 "iterations=32"
4.0759 453.076 "iterations=64"
7.77975 186.203 "iterations=128"
END
$curve5 << END
0.755605 1121.07 "iterations=4"
1.06146 1094.29 "iterations=8"
1.90618 949.921 "iterations=16"
3.51245 667.722 "iterations=32"
6.6772 414.765 "iterations=64"
13.1103 174.888 "iterations=128"
END
$curve6 << END
1.43931 139.877 "iterations=1"
2.00019 42.7502 "iterations=2"
2.86988 26.3203 "iterations=3"
3.2641 23.756 "iterations=4"
4.32998 20.5292 "iterations=6"
5.82313 16.119 "iterations=8"
9.01844 18.1511 "iterations=12"
10.7708 12.3494 "iterations=16"
END
$curve7 << END
1.15741 113.681 "iterations=1"
1.60397 42.908 "iterations=2"
2.54307 31.678 "iterations=4"
4.21056 52.8786 "iterations=8"
END
$curve8 << END
1.8752 35.6642 "passes=2 iterations=1"
2.46583 17.5854 "passes=2 iterations=2"
2.60058 24.8958 "passes=3 iterations=1"
2.94979 9.97224 "passes=3 iterations=2"
3.19455 7.87578 "passes=2 iterations=4"
3.48598 7.21681 "passes=4 iterations=2"
3.48656 16.0925 "passes=4 iterations=1"
3.93078 6.95032 "passes=3 iterations=4"
4.15695 5.92657 "passes=2 iterations=6"
4.22556 4.87534 "passes=4 iterations=4"
4.65287 10.0032 "passes=6 iterations=1"
4.781 3.13049 "passes=3 iterations=6"
4.87463 5.98642 "passes=6 iterations=2"
5.84126 6.95657 "passes=8 iterations=1"
6.02405 3.22939 "passes=8 iterations=2"
END
$curve9 << END
2.24711 43.7046 "passes=1 substeps=2"
4.64244 56.4302 "passes=1 substeps=4"
8.87883 86.4886 "passes=1 substeps=8"
18.1652 111.998 "passes=1 substeps=16"
END
$curve10 << END
1.59854 173.435 "passes=1 iterations=2"
2.2398 170.738 "passes=2 iterations=2"
2.86257 164.708 "passes=3 iterations=2"
3.52377 169.723 "passes=4 iterations=2"
4.1946 170.325 "passes=4 iterations=4"
5.58354 171.786 "passes=6 iterations=4"
END
$curve11 << END
5.24007 169.342 "passes=3 substeps=2"
9.98607 178.563 "passes=3 substeps=4"
22.3543 181.39 "passes=3 substeps=8"
END
$curve12 << END
0.414006 4301.97 "substeps=1"
0.768458 3825.9 "substeps=2"
1.42494 2649.69 "substeps=4"
2.88871 883.471 "substeps=8"
5.79232 162.397 "substeps=16"
11.2353 138.687 "substeps=32"
18.7997 169.757 "substeps=64"
END
$curve13 << END
1.19808 3822.02 "iterations=4"
4.34258 2534.26 "iterations=16"
17.1888 717.531 "iterations=64"
END
$curve14 << END
4.47796 1956.77 "iterations=16"
16.2871 355.594 "iterations=64"
END
$curve15 << END
6.16308 127.951 "iterations=1 substeps=16"
24.5395 182.164 "iterations=1 substeps=64"
END
$curve16 << END
111.698 179.759 "substeps=740"
151.545 180.149 "substeps=1138"
312.563 179.008 "substeps=2276"
END
$curve17 << END
144.763 181.659 "substeps=740"
539.605 180.028 "substeps=2276"
END
$default << END
2.94979 9.97224 "passes=3 iterations=2"
END
set terminal svg size 1200,760 font 'DejaVu Sans,13' background rgb 'white'
set output 'accuracy-hanging-128-a-1s.svg'
plot $front using 1:2 with lines linewidth 9 linecolor rgb '#ffe8a3' title 'the front: nothing is cheaper and better', \
  97.5318 with lines dashtype 2 linewidth 1.2 linecolor rgb '#495057' title 'one linearisation, solved exactly', \
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
  $curve14 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 13 linecolor rgb '#e64980' title 'Fibres and sets', \
  $curve15 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 12 linecolor rgb '#f783ac' title 'Fibres and sets in substeps', \
  $curve16 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 15 linecolor rgb '#495057' title 'Symplectic Euler', \
  $curve17 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 14 linecolor rgb '#adb5bd' title 'Explicit Euler', \
  $front using 1:2:3 with labels left offset 0.8,0.6 font ',7' textcolor rgb '#343a40' noenhanced notitle, \
  $default using 1:2 with points pointtype 3 pointsize 3 linewidth 3 linecolor rgb '#000000' title 'Weft''s default'
set terminal pngcairo size 1200,760 font 'DejaVu Sans,10' background rgb 'white'
set output 'accuracy-hanging-128-a-1s.png'
plot $front using 1:2 with lines linewidth 9 linecolor rgb '#ffe8a3' title 'the front: nothing is cheaper and better', \
  97.5318 with lines dashtype 2 linewidth 1.2 linecolor rgb '#495057' title 'one linearisation, solved exactly', \
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
  $curve14 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 13 linecolor rgb '#e64980' title 'Fibres and sets', \
  $curve15 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 12 linecolor rgb '#f783ac' title 'Fibres and sets in substeps', \
  $curve16 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 15 linecolor rgb '#495057' title 'Symplectic Euler', \
  $curve17 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 14 linecolor rgb '#adb5bd' title 'Explicit Euler', \
  $front using 1:2:3 with labels left offset 0.8,0.6 font ',7' textcolor rgb '#343a40' noenhanced notitle, \
  $default using 1:2 with points pointtype 3 pointsize 3 linewidth 3 linecolor rgb '#000000' title 'Weft''s default'
