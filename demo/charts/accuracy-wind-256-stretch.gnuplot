set encoding utf8
set logscale xy
set format '%g'
set border 3 linecolor rgb '#495057'
set tics nomirror
set grid xtics ytics mxtics mytics linetype 1 linewidth 1 linecolor rgb '#dde2e6', linetype 1 linewidth 0.5 linecolor rgb '#eff2f5'
set xrange [1.06797:155.044]
set yrange [6.4894:46513.1]
set title 'Hung sheet in wind, 256 × 256 particles: worst stretch of a thread after 1 s' noenhanced font ',13'
set xlabel 'median time of a frame of 1/60 s [ms]'
set ylabel 'worst stretch [%]'
set key outside right top Left reverse samplen 2 spacing 1.25 font ',10' noenhanced
set rmargin 42
set bmargin 8
set label 1 'Intel(R) Xeon(R) Processor; 2 threads, 2 used; commit 4b8e1f7; κ = 36409; weft_study accuracy, then weft_study plot'."\n".'Not drawn, since they diverged: Fibres and sets in substeps iterations=1 substeps=16; Fibres and sets in substeps iterations=1 substeps=4; Fibres and sets iterations=1'."\n".' Fibres and sets iterations=16; Fibres and sets iterations=4' at screen 0.012, screen 0.085 font ',8' textcolor rgb '#6c757d' noenhanced
$curve0 << END
1.82138 658.93 "iterations=1"
1.91934 616.951 "iterations=3"
2.67905 638.653 "iterations=7"
4.29241 701.294 "iterations=15"
7.37196 674.769 "iterations=31"
13.6218 624.579 "iterations=63"
26.1286 622.781 "iterations=127"
50.5539 387.701 "iterations=255"
END
$curve1 << END
1.71835 8539.41 "iterations=2"
2.91597 804.132 "iterations=8"
4.45815 907.15 "iterations=16"
13.8915 662.259 "iterations=64"
END
$curve2 << END
2.18789 36.2802 "iterations=1"
3.5681 25.9651 "iterations=7"
7.84932 9.27057 "iterations=31"
26.4928 10.6208 "iterations=127"
END
$curve3 << END
5.26822 720.183 "iterations=7 substeps=2"
11.9669 695.934 "iterations=7 substeps=4"
21.2849 328.344 "iterations=7 substeps=8"
46.4435 60.1603 "iterations=7 substeps=16"
END
$curve4 << END
2.32793 263.785 "iterations=4"
3.06152 245.182 "iterations=8"
5.50216 306.63 "iterations=16"
9.55566 238.048 "iterations=32"
14.0556 48.566 "iterations=64"
27.4798 54.2088 "iterations=128"
END
$curve5 << END
2.75229 433.406 "iterations=4"
4.38096 426.035 "iterations=8"
7.6219 462.469 "iterations=16"
14.6527 196.803 "iterations=32"
28.5025 35.9083 "iterations=64"
54.095 60.5694 "iterations=128"
END
$curve6 << END
5.57583 62.9141 "iterations=1"
8.2735 61.206 "iterations=2"
10.5201 62.1661 "iterations=3"
13.6756 60.4968 "iterations=4"
16.9195 60.3568 "iterations=6"
23.5617 60.3324 "iterations=8"
30.2671 58.5242 "iterations=12"
39.5936 59.8112 "iterations=16"
END
$curve7 << END
4.75049 59.9652 "iterations=1"
6.28052 62.1722 "iterations=2"
8.63255 65.0775 "iterations=4"
14.151 125.464 "iterations=8"
END
$curve8 << END
6.98688 60.8278 "passes=2 iterations=1"
7.31192 57.9157 "passes=2 iterations=2"
8.28195 57.6884 "passes=3 iterations=1"
9.77174 56.8753 "passes=3 iterations=2"
10.1309 57.6276 "passes=2 iterations=4"
11.206 57.2729 "passes=4 iterations=1"
11.6541 59.1409 "passes=4 iterations=2"
13.0033 58.5571 "passes=2 iterations=6"
14.2358 58.5144 "passes=3 iterations=4"
14.4678 59.6584 "passes=4 iterations=4"
14.9374 58.0876 "passes=3 iterations=6"
15.0049 56.6756 "passes=6 iterations=1"
17.1861 58.1679 "passes=6 iterations=2"
18.5959 57.1165 "passes=8 iterations=1"
19.5842 58.1965 "passes=8 iterations=2"
END
$curve9 << END
7.9737 59.5277 "passes=1 substeps=2"
15.1384 59.0074 "passes=1 substeps=4"
30.2416 59.1714 "passes=1 substeps=8"
61.6234 58.0429 "passes=1 substeps=16"
END
$curve10 << END
5.62957 112.716 "passes=1 iterations=2"
7.77732 53.8832 "passes=2 iterations=2"
9.79137 54.7015 "passes=3 iterations=2"
11.8664 56.303 "passes=4 iterations=2"
14.2938 56.1555 "passes=4 iterations=4"
18.9421 57.2932 "passes=6 iterations=4"
END
$curve11 << END
20.2627 55.6877 "passes=3 substeps=2"
47.3101 57.1682 "passes=3 substeps=4"
90.6399 58.3668 "passes=3 substeps=8"
END
$curve12 << END
1.52567 29070.7 "substeps=1"
2.72152 26950.5 "substeps=2"
5.96701 23600.6 "substeps=4"
10.3749 16952.6 "substeps=8"
19.0759 7525.56 "substeps=16"
37.3228 2271.19 "substeps=32"
74.234 1107.27 "substeps=64"
END
$curve13 << END
3.17059 24612.5 "iterations=4"
10.9252 20565.7 "iterations=16"
43.7428 13680.8 "iterations=64"
END
$curve14 << END
60.7079 16947.7 "iterations=64"
END
$curve15 << END
96.9024 857.307 "iterations=1 substeps=64"
END
$default << END
9.77174 56.8753 "passes=3 iterations=2"
END
set terminal svg size 1200,760 font 'DejaVu Sans,13' background rgb 'white'
set output 'accuracy-wind-256-stretch.svg'
plot 59.6698 with lines dashtype 2 linewidth 1.2 linecolor rgb '#495057' title 'the true motion (tiny steps)', \
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
  $default using 1:2 with points pointtype 3 pointsize 3 linewidth 3 linecolor rgb '#000000' title 'Weft''s default'
set terminal pngcairo size 1200,760 font 'DejaVu Sans,10' background rgb 'white'
set output 'accuracy-wind-256-stretch.png'
plot 59.6698 with lines dashtype 2 linewidth 1.2 linecolor rgb '#495057' title 'the true motion (tiny steps)', \
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
  $default using 1:2 with points pointtype 3 pointsize 3 linewidth 3 linecolor rgb '#000000' title 'Weft''s default'
