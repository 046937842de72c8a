set encoding utf8
set logscale xy
set format '%g'
set border 3 linecolor rgb '#495057'
set tics nomirror
set grid xtics ytics mxtics mytics linetype 1 linewidth 1 linecolor rgb '#dde2e6', linetype 1 linewidth 0.5 linecolor rgb '#eff2f5'
set xrange [1.20284:86.552]
set xtics (2, 5, 10, 20, 50)
set yrange [8.05049:435.843]
set ytics (10, 20, 50, 100, 200)
set title 'Hung sheet in wind, 256 × 256 particles: distance from the method''s own converged step after 1 s' noenhanced font ',13'
set xlabel 'median time of a frame of 1/60 s [ms]'
set ylabel 'RMS distance of particles [mm]'
set key outside right top Left reverse samplen 2 spacing 1.25 font ',10' noenhanced
set rmargin 42
set bmargin 8
set label 1 'Intel(R) Xeon(R) Processor; 2 threads, 2 used; commit 4b8e1f7; κ = 36409; weft_study accuracy, then weft_study plot'."\n".'Not drawn, since they diverged: Fibres and sets in substeps iterations=1 substeps=16; Fibres and sets in substeps iterations=1 substeps=4; Fibres and sets iterations=1'."\n".' Fibres and sets iterations=16; Fibres and sets iterations=4' at screen 0.012, screen 0.085 font ',8' textcolor rgb '#6c757d' noenhanced
$curve0 << END
1.82138 157.048 "iterations=1"
1.91934 164.13 "iterations=3"
2.67905 195.256 "iterations=7"
4.29241 227.987 "iterations=15"
7.37196 244.09 "iterations=31"
13.6218 231.656 "iterations=63"
26.1286 218.689 "iterations=127"
50.5539 152.075 "iterations=255"
END
$curve1 << END
1.71835 225.472 "iterations=2"
2.91597 221.379 "iterations=8"
4.45815 272.402 "iterations=16"
13.8915 255.126 "iterations=64"
END
$curve2 << END
2.18789 151.549 "iterations=1"
3.5681 115.596 "iterations=7"
7.84932 176.724 "iterations=31"
26.4928 143.301 "iterations=127"
END
$curve3 << END
2.32793 134.058 "iterations=4"
3.06152 115.239 "iterations=8"
5.50216 112.375 "iterations=16"
9.55566 104.263 "iterations=32"
14.0556 64.8118 "iterations=64"
27.4798 60.4918 "iterations=128"
END
$curve4 << END
2.75229 157.523 "iterations=4"
4.38096 158.507 "iterations=8"
7.6219 165.1 "iterations=16"
14.6527 86.8267 "iterations=32"
28.5025 65.8769 "iterations=64"
54.095 57.6953 "iterations=128"
END
$curve5 << END
5.57583 67.0008 "iterations=1"
8.2735 65.0979 "iterations=2"
10.5201 62.8591 "iterations=3"
13.6756 62.1396 "iterations=4"
16.9195 60.9797 "iterations=6"
23.5617 60.214 "iterations=8"
30.2671 57.8914 "iterations=12"
39.5936 58.6072 "iterations=16"
END
$curve6 << END
4.75049 67.4978 "iterations=1"
6.28052 63.9131 "iterations=2"
8.63255 85.6299 "iterations=4"
14.151 114.266 "iterations=8"
END
$curve7 << END
6.98688 61.3486 "passes=2 iterations=1"
7.31192 53.8976 "passes=2 iterations=2"
8.28195 54.5341 "passes=3 iterations=1"
9.77174 38.7422 "passes=3 iterations=2"
10.1309 29.972 "passes=2 iterations=4"
11.206 50.1754 "passes=4 iterations=1"
11.6541 29.4956 "passes=4 iterations=2"
13.0033 25.6148 "passes=2 iterations=6"
14.2358 21.3494 "passes=3 iterations=4"
14.4678 19.8629 "passes=4 iterations=4"
14.9374 11.5007 "passes=3 iterations=6"
15.0049 38.9236 "passes=6 iterations=1"
17.1861 19.998 "passes=6 iterations=2"
18.5959 31.2786 "passes=8 iterations=1"
19.5842 17.0026 "passes=8 iterations=2"
END
$curve8 << END
5.62957 60.461 "passes=1 iterations=2"
7.77732 57.5764 "passes=2 iterations=2"
9.79137 48.1603 "passes=3 iterations=2"
11.8664 41.9822 "passes=4 iterations=2"
14.2938 26.7061 "passes=4 iterations=4"
18.9421 23.654 "passes=6 iterations=4"
END
$default << END
9.77174 38.7422 "passes=3 iterations=2"
END
set terminal svg size 1200,760 font 'DejaVu Sans,13' background rgb 'white'
set output 'accuracy-wind-256-own-1s.svg'
plot $curve0 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 7 linecolor rgb '#d62728' title 'Jacobi (Kang): odd', \
  $curve1 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#f4a6a6' title 'Jacobi (Kang): even', \
  $curve2 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 9 linecolor rgb '#8c1515' title 'Jacobi (Kang) with tethers', \
  $curve3 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 5 linecolor rgb '#f59f00' title 'Chebyshev', \
  $curve4 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 13 linecolor rgb '#b8860b' title 'Conjugate gradients', \
  $curve5 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 7 linecolor rgb '#1f77b4' title 'Multilevel: nonlinear CG', \
  $curve6 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#74c0fc' title 'Multilevel: one linear solve', \
  $curve7 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 5 linecolor rgb '#0b3d91' title 'Multilevel: Newton passes', \
  $curve8 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 9 linecolor rgb '#2b8a3e' title 'Multilevel: BDF2', \
  $default using 1:2 with points pointtype 3 pointsize 3 linewidth 3 linecolor rgb '#000000' title 'Weft''s default'
set terminal pngcairo size 1200,760 font 'DejaVu Sans,10' background rgb 'white'
set output 'accuracy-wind-256-own-1s.png'
plot $curve0 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 7 linecolor rgb '#d62728' title 'Jacobi (Kang): odd', \
  $curve1 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#f4a6a6' title 'Jacobi (Kang): even', \
  $curve2 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 9 linecolor rgb '#8c1515' title 'Jacobi (Kang) with tethers', \
  $curve3 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 5 linecolor rgb '#f59f00' title 'Chebyshev', \
  $curve4 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 13 linecolor rgb '#b8860b' title 'Conjugate gradients', \
  $curve5 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 7 linecolor rgb '#1f77b4' title 'Multilevel: nonlinear CG', \
  $curve6 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#74c0fc' title 'Multilevel: one linear solve', \
  $curve7 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 5 linecolor rgb '#0b3d91' title 'Multilevel: Newton passes', \
  $curve8 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 9 linecolor rgb '#2b8a3e' title 'Multilevel: BDF2', \
  $default using 1:2 with points pointtype 3 pointsize 3 linewidth 3 linecolor rgb '#000000' title 'Weft''s default'
