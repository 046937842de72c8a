set encoding utf8
set logscale xy
set format '%g'
set border 3 linecolor rgb '#495057'
set tics nomirror
set grid xtics ytics mxtics mytics linetype 1 linewidth 1 linecolor rgb '#dde2e6', linetype 1 linewidth 0.5 linecolor rgb '#eff2f5'
set xrange [0.89901:154.803]
set yrange [5.86069:46513.1]
set title 'Hung sheet in wind, 256 × 256 particles: worst stretch of a thread after 1 s' noenhanced font ',13'
set xlabel 'median time of a frame of 1/60 s [ms]'
set ylabel 'worst stretch [%]'
set key outside right top Left reverse samplen 2 spacing 1.25 font ',10' noenhanced
set rmargin 42
set bmargin 8
set label 1 'Intel(R) Xeon(R) Processor; 2 threads, 2 used; commit 626c968+; κ = 36409; weft_study accuracy, then weft_study plot'."\n".'Not drawn, since they diverged: Fibres and sets in substeps iterations=1 substeps=16; Fibres and sets in substeps iterations=1 substeps=4; Fibres and sets iterations=1'."\n".' Fibres and sets iterations=16; Fibres and sets iterations=4' at screen 0.012, screen 0.085 font ',8' textcolor rgb '#6c757d' noenhanced
$curve0 << END
2.1207 663.55 "iterations=1"
2.68312 615.264 "iterations=3"
3.67217 639.318 "iterations=7"
4.7819 699.536 "iterations=15"
9.41525 674.406 "iterations=31"
19.6345 624.633 "iterations=63"
36.962 625.072 "iterations=127"
73.1499 387.704 "iterations=255"
END
$curve1 << END
1.99648 9267.4 "iterations=2"
3.78864 787.272 "iterations=8"
6.37019 915.71 "iterations=16"
20.9216 650.793 "iterations=64"
END
$curve2 << END
3.0069 46.7496 "iterations=1"
4.67409 24.425 "iterations=7"
12.232 10.1663 "iterations=31"
40.2002 8.37242 "iterations=127"
END
$curve3 << END
8.01725 720.537 "iterations=7 substeps=2"
16.2529 695.054 "iterations=7 substeps=4"
31.4235 326.601 "iterations=7 substeps=8"
55.9204 59.9913 "iterations=7 substeps=16"
END
$curve4 << END
2.89088 251.453 "iterations=4"
3.95438 248.468 "iterations=8"
6.15106 298.564 "iterations=16"
11.8956 235.486 "iterations=32"
22.8706 49.0936 "iterations=64"
59.3073 54.6246 "iterations=128"
END
$curve5 << END
3.76371 435.526 "iterations=4"
5.88528 430.425 "iterations=8"
10.6825 444.899 "iterations=16"
21.2106 203.656 "iterations=32"
36.0031 36.5125 "iterations=64"
65.7725 60.6181 "iterations=128"
END
$curve6 << END
8.2025 60.7886 "iterations=2"
8.49403 62.4508 "iterations=1"
11.9278 60.981 "iterations=3"
12.5361 61.1082 "iterations=4"
16.4748 61.1975 "iterations=6"
21.3129 59.7921 "iterations=8"
34.7016 60.4025 "iterations=12"
51.4033 58.4996 "iterations=16"
END
$curve7 << END
4.91458 62.6991 "iterations=1"
7.01824 71.68 "iterations=2"
10.6139 68.5419 "iterations=4"
16.1809 67.9917 "iterations=8"
END
$curve8 << END
7.93032 60.8877 "passes=2 iterations=1"
8.97221 57.5716 "passes=3 iterations=1"
9.54581 57.7844 "passes=2 iterations=2"
10.2895 56.1071 "passes=3 iterations=2"
11.6295 57.6887 "passes=2 iterations=4"
11.9325 56.8729 "passes=4 iterations=1"
12.9419 57.2958 "passes=4 iterations=2"
13.1876 59.1926 "passes=3 iterations=4"
14.1129 58.7346 "passes=2 iterations=6"
15.7933 56.163 "passes=6 iterations=1"
16.0867 59.6402 "passes=4 iterations=4"
16.955 59.279 "passes=3 iterations=6"
21.1082 59.0832 "passes=6 iterations=2"
25.0647 56.895 "passes=8 iterations=1"
26.102 58.4141 "passes=8 iterations=2"
END
$curve9 << END
9.27117 60.0025 "passes=1 substeps=2"
19.7578 59.3888 "passes=1 substeps=4"
42.1422 60.6882 "passes=1 substeps=8"
67.6443 57.9713 "passes=1 substeps=16"
END
$curve10 << END
6.15234 108.015 "passes=1 iterations=2"
9.5201 54.1227 "passes=2 iterations=2"
12.3304 54.0451 "passes=3 iterations=2"
15.8524 55.883 "passes=4 iterations=2"
21.2148 57.0431 "passes=4 iterations=4"
24.6385 56.9528 "passes=6 iterations=4"
END
$curve11 << END
25.2898 55.9433 "passes=3 substeps=2"
54.8246 57.5382 "passes=3 substeps=4"
89.0575 58.5729 "passes=3 substeps=8"
END
$curve12 << END
1.2843 29070.7 "substeps=1"
2.66067 26950.5 "substeps=2"
4.94776 23600.6 "substeps=4"
9.45331 16952.6 "substeps=8"
18.734 7525.56 "substeps=16"
37.9799 2271.19 "substeps=32"
80.199 1107.27 "substeps=64"
END
$curve13 << END
3.3646 24612.5 "iterations=4"
11.0673 20565.7 "iterations=16"
43.6682 13680.8 "iterations=64"
END
$curve14 << END
56.1211 16947.7 "iterations=64"
END
$curve15 << END
96.7517 857.307 "iterations=1 substeps=64"
END
$default << END
10.2895 56.1071 "passes=3 iterations=2"
END
set terminal svg size 1200,760 font 'DejaVu Sans,13' background rgb 'white'
set output 'accuracy-wind-256-stretch.svg'
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
  $curve10 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 9 linecolor rgb '#2b8a3e' title 'Multilevel: BDF2', \
  $curve11 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 11 linecolor rgb '#74b816' title 'Multilevel: BDF2 in substeps', \
  $curve12 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 7 linecolor rgb '#9c36b5' title 'XPBD: substeps', \
  $curve13 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#da77f2' title 'XPBD: iterations', \
  $curve14 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 13 linecolor rgb '#e64980' title 'Fibres and sets', \
  $curve15 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 12 linecolor rgb '#f783ac' title 'Fibres and sets in substeps', \
  $default using 1:2 with points pointtype 3 pointsize 3 linewidth 3 linecolor rgb '#000000' title 'Weft''s default'
set terminal pngcairo size 1200,760 font 'DejaVu Sans,10' background rgb 'white'
set output 'accuracy-wind-256-stretch.png'
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
  $curve10 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 9 linecolor rgb '#2b8a3e' title 'Multilevel: BDF2', \
  $curve11 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 11 linecolor rgb '#74b816' title 'Multilevel: BDF2 in substeps', \
  $curve12 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 7 linecolor rgb '#9c36b5' title 'XPBD: substeps', \
  $curve13 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#da77f2' title 'XPBD: iterations', \
  $curve14 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 13 linecolor rgb '#e64980' title 'Fibres and sets', \
  $curve15 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 12 linecolor rgb '#f783ac' title 'Fibres and sets in substeps', \
  $default using 1:2 with points pointtype 3 pointsize 3 linewidth 3 linecolor rgb '#000000' title 'Weft''s default'
