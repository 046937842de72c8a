set encoding utf8
set logscale xy
set format '%g'
set border 3 linecolor rgb '#495057'
set tics nomirror
set grid xtics ytics mxtics mytics linetype 1 linewidth 1 linecolor rgb '#dde2e6', linetype 1 linewidth 0.5 linecolor rgb '#eff2f5'
set xrange [0.969255:127.632]
set yrange [1.99393:7139.14]
set title 'Sheet hung by two corners, 256 × 256 particles: distance from converged backward Euler after 1 s' noenhanced font ',13'
set xlabel 'median time of a frame of 1/60 s [ms]'
set ylabel 'RMS distance of particles [mm]'
set key outside right top Left reverse samplen 2 spacing 1.25 font ',10' noenhanced
set rmargin 42
set bmargin 8
set label 1 'Intel(R) Xeon(R) Processor; 2 threads, 2 used; commit 626c968+; κ = 36409; weft_study accuracy, then weft_study plot'."\n".'Not drawn, since they diverged: Fibres and sets in substeps iterations=1 substeps=16; Fibres and sets in substeps iterations=1 substeps=4; Fibres and sets iterations=1'."\n".' Fibres and sets iterations=16; Fibres and sets iterations=4; Fibres and sets iterations=64' at screen 0.012, screen 0.085 font ',8' textcolor rgb '#6c757d' noenhanced
$front << END
1.38465 4461.96 "substeps=1"
1.60157 1079.01 "iterations=1"
2.16107 1025.65 "iterations=1"
3.54933 979.184 "iterations=7"
4.09369 103.444 "iterations=1"
5.06269 101.614 "iterations=1"
5.50249 27.9407 "iterations=2"
7.64275 22.2181 "passes=2 iterations=2"
9.29893 21.1291 "iterations=4"
9.82728 6.35074 "passes=3 iterations=2"
11.8479 5.15292 "passes=4 iterations=2"
14.7757 2.84847 "passes=4 iterations=4"
END
$curve0 << END
1.60157 1079.01 "iterations=1"
2.05668 1082.76 "iterations=3"
3.00878 1091.86 "iterations=7"
4.9116 1107.86 "iterations=15"
8.13761 1125.86 "iterations=31"
15.9449 1135.55 "iterations=63"
28.9889 1134.17 "iterations=127"
60.1305 1150.54 "iterations=255"
END
$curve1 << END
1.68607 1097.92 "iterations=2"
3.01666 1098.11 "iterations=8"
4.81886 1121.72 "iterations=16"
15.2838 1141.98 "iterations=64"
END
$curve2 << END
2.16107 1025.65 "iterations=1"
3.54933 979.184 "iterations=7"
8.37679 826.637 "iterations=31"
28.4986 766.19 "iterations=127"
END
$curve3 << END
5.50856 1122.6 "iterations=7 substeps=2"
10.8149 1144.08 "iterations=7 substeps=4"
21.3717 962.722 "iterations=7 substeps=8"
43.1197 543.824 "iterations=7 substeps=16"
END
$curve4 << END
2.3426 1077.26 "iterations=4"
3.12025 1077.76 "iterations=8"
4.97578 1074.97 "iterations=16"
8.85925 1011.93 "iterations=32"
15.5253 751.166 "iterations=64"
30.13 478.698 "iterations=128"
END
$curve5 << END
2.68719 1085.07 "iterations=4"
4.36625 1092.65 "iterations=8"
7.48366 1094.58 "iterations=16"
14.038 974.622 "iterations=32"
27.6239 698.049 "iterations=64"
54.6689 426.429 "iterations=128"
END
$curve6 << END
5.06269 101.614 "iterations=1"
7.6397 73.7742 "iterations=2"
9.93413 33.2957 "iterations=3"
12.2241 36.2742 "iterations=4"
16.6832 31.0512 "iterations=6"
21.8559 29.415 "iterations=8"
30.6911 30.8213 "iterations=12"
39.4223 37.0022 "iterations=16"
END
$curve7 << END
4.09369 103.444 "iterations=1"
5.50249 27.9407 "iterations=2"
9.29893 21.1291 "iterations=4"
13.8963 129.981 "iterations=8"
END
$curve8 << END
6.18065 31.4381 "passes=2 iterations=1"
7.64275 22.2181 "passes=2 iterations=2"
8.32298 28.0904 "passes=3 iterations=1"
9.82728 6.35074 "passes=3 iterations=2"
10.4451 13.4767 "passes=4 iterations=1"
10.5967 9.59214 "passes=2 iterations=4"
11.8479 5.15292 "passes=4 iterations=2"
12.7991 5.40435 "passes=3 iterations=4"
13.3542 5.24896 "passes=2 iterations=6"
14.7757 2.84847 "passes=4 iterations=4"
15.1221 9.25929 "passes=6 iterations=1"
15.6459 4.59812 "passes=3 iterations=6"
16.592 3.28664 "passes=6 iterations=2"
19.443 3.91835 "passes=8 iterations=1"
20.4397 2.9268 "passes=8 iterations=2"
END
$curve9 << END
7.69578 49.0469 "passes=1 substeps=2"
14.9449 50.3425 "passes=1 substeps=4"
30.2282 90.2027 "passes=1 substeps=8"
60.5766 106.188 "passes=1 substeps=16"
END
$curve10 << END
5.70723 159.967 "passes=1 iterations=2"
7.77169 162.377 "passes=2 iterations=2"
10.1821 169.983 "passes=3 iterations=2"
12.1162 165.684 "passes=4 iterations=2"
14.9937 166.968 "passes=4 iterations=4"
19.5325 157.405 "passes=6 iterations=4"
END
$curve11 << END
19.7516 163.472 "passes=3 substeps=2"
39.0259 175.373 "passes=3 substeps=4"
78.591 176.346 "passes=3 substeps=8"
END
$curve12 << END
1.38465 4461.96 "substeps=1"
2.01047 4303.89 "substeps=2"
3.79671 3896.74 "substeps=4"
7.53775 2852.97 "substeps=8"
14.743 1142.02 "substeps=16"
29.5906 210.901 "substeps=32"
58.2467 132.466 "substeps=64"
END
$curve13 << END
3.01893 4326.14 "iterations=4"
10.6864 3888.5 "iterations=16"
40.9575 2685.64 "iterations=64"
END
$curve14 << END
79.7699 164.465 "iterations=1 substeps=64"
END
$default << END
9.82728 6.35074 "passes=3 iterations=2"
END
set terminal svg size 1200,760 font 'DejaVu Sans,13' background rgb 'white'
set output 'accuracy-hanging-256-a-1s.svg'
plot $front using 1:2 with lines linewidth 9 linecolor rgb '#ffe8a3' title 'the front: nothing is cheaper and better', \
  107.584 with lines dashtype 2 linewidth 1.2 linecolor rgb '#495057' title 'one linearisation, solved exactly', \
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
set output 'accuracy-hanging-256-a-1s.png'
plot $front using 1:2 with lines linewidth 9 linecolor rgb '#ffe8a3' title 'the front: nothing is cheaper and better', \
  107.584 with lines dashtype 2 linewidth 1.2 linecolor rgb '#495057' title 'one linearisation, solved exactly', \
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
