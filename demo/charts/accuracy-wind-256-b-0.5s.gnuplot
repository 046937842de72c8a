set encoding utf8
set logscale xy
set format '%g'
set border 3 linecolor rgb '#495057'
set tics nomirror
set grid xtics ytics mxtics mytics linetype 1 linewidth 1 linecolor rgb '#dde2e6', linetype 1 linewidth 0.5 linecolor rgb '#eff2f5'
set xrange [1.06797:155.044]
set yrange [5.76795:1032.39]
set title 'Hung sheet in wind, 256 × 256 particles: distance from the true motion (tiny steps) after 0.5 s' noenhanced font ',13'
set xlabel 'median time of a frame of 1/60 s [ms]'
set ylabel 'RMS distance of particles [mm]'
set key outside right top Left reverse samplen 2 spacing 1.25 font ',10' noenhanced
set rmargin 42
set bmargin 8
set label 1 'Intel(R) Xeon(R) Processor; 2 threads, 2 used; commit 4b8e1f7; κ = 36409; weft_study accuracy, then weft_study plot'."\n".'Not drawn, since they diverged: Fibres and sets in substeps iterations=1 substeps=16; Fibres and sets in substeps iterations=1 substeps=4; Fibres and sets iterations=1'."\n".' Fibres and sets iterations=16; Fibres and sets iterations=4' at screen 0.012, screen 0.085 font ',8' textcolor rgb '#6c757d' noenhanced
$front << END
1.52567 546.327 "substeps=1"
1.71835 187.941 "iterations=2"
1.91934 177.609 "iterations=3"
2.67905 157.7 "iterations=7"
2.91597 156.213 "iterations=8"
4.29241 141.625 "iterations=15"
4.38096 139.311 "iterations=8"
4.75049 27.4918 "iterations=1"
5.62957 25.9611 "passes=1 iterations=2"
7.31192 24.9279 "passes=2 iterations=2"
7.9737 24.4918 "passes=1 substeps=2"
9.77174 24.2658 "passes=3 iterations=2"
10.1309 22.9753 "passes=2 iterations=4"
11.6541 22.5547 "passes=4 iterations=2"
13.0033 22.0897 "passes=2 iterations=6"
14.2938 21.9575 "passes=4 iterations=4"
14.4678 19.4385 "passes=4 iterations=4"
15.1384 18.1677 "passes=1 substeps=4"
20.2627 17.2452 "passes=3 substeps=2"
30.2416 15.2886 "passes=1 substeps=8"
47.3101 10.3851 "passes=3 substeps=4"
90.6399 8.23993 "passes=3 substeps=8"
END
$curve0 << END
1.82138 198.376 "iterations=1"
1.91934 177.609 "iterations=3"
2.67905 157.7 "iterations=7"
4.29241 141.625 "iterations=15"
7.37196 127.789 "iterations=31"
13.6218 112.627 "iterations=63"
26.1286 96.3851 "iterations=127"
50.5539 89.3917 "iterations=255"
END
$curve1 << END
1.71835 187.941 "iterations=2"
2.91597 156.213 "iterations=8"
4.45815 144.688 "iterations=16"
13.8915 114.339 "iterations=64"
END
$curve2 << END
2.18789 211.432 "iterations=1"
3.5681 162.233 "iterations=7"
7.84932 91.6761 "iterations=31"
26.4928 66.6879 "iterations=127"
END
$curve3 << END
5.26822 131.128 "iterations=7 substeps=2"
11.9669 108.487 "iterations=7 substeps=4"
21.2849 88.6897 "iterations=7 substeps=8"
46.4435 72.0247 "iterations=7 substeps=16"
END
$curve4 << END
2.32793 190.397 "iterations=4"
3.06152 162.794 "iterations=8"
5.50216 119.048 "iterations=16"
9.55566 91.0506 "iterations=32"
14.0556 73.7584 "iterations=64"
27.4798 51.5019 "iterations=128"
END
$curve5 << END
2.75229 172.595 "iterations=4"
4.38096 139.311 "iterations=8"
7.6219 96.5872 "iterations=16"
14.6527 91.0259 "iterations=32"
28.5025 66.6499 "iterations=64"
54.095 46.283 "iterations=128"
END
$curve6 << END
5.57583 31.1281 "iterations=1"
8.2735 28.1291 "iterations=2"
10.5201 28.0818 "iterations=3"
13.6756 27.22 "iterations=4"
16.9195 27.6958 "iterations=6"
23.5617 27.9729 "iterations=8"
30.2671 27.8887 "iterations=12"
39.5936 27.4312 "iterations=16"
END
$curve7 << END
4.75049 27.4918 "iterations=1"
6.28052 26.0992 "iterations=2"
8.63255 96.7534 "iterations=4"
14.151 110.963 "iterations=8"
END
$curve8 << END
6.98688 27.2226 "passes=2 iterations=1"
7.31192 24.9279 "passes=2 iterations=2"
8.28195 25.3226 "passes=3 iterations=1"
9.77174 24.2658 "passes=3 iterations=2"
10.1309 22.9753 "passes=2 iterations=4"
11.206 25.0451 "passes=4 iterations=1"
11.6541 22.5547 "passes=4 iterations=2"
13.0033 22.0897 "passes=2 iterations=6"
14.2358 22.2116 "passes=3 iterations=4"
14.4678 19.4385 "passes=4 iterations=4"
14.9374 21.1636 "passes=3 iterations=6"
15.0049 24.0525 "passes=6 iterations=1"
17.1861 21.4487 "passes=6 iterations=2"
18.5959 22.6236 "passes=8 iterations=1"
19.5842 21.7346 "passes=8 iterations=2"
END
$curve9 << END
7.9737 24.4918 "passes=1 substeps=2"
15.1384 18.1677 "passes=1 substeps=4"
30.2416 15.2886 "passes=1 substeps=8"
61.6234 11.8512 "passes=1 substeps=16"
END
$curve10 << END
5.62957 25.9611 "passes=1 iterations=2"
7.77732 25.5306 "passes=2 iterations=2"
9.79137 24.756 "passes=3 iterations=2"
11.8664 23.3529 "passes=4 iterations=2"
14.2938 21.9575 "passes=4 iterations=4"
18.9421 21.6518 "passes=6 iterations=4"
END
$curve11 << END
20.2627 17.2452 "passes=3 substeps=2"
47.3101 10.3851 "passes=3 substeps=4"
90.6399 8.23993 "passes=3 substeps=8"
END
$curve12 << END
1.52567 546.327 "substeps=1"
2.72152 617.208 "substeps=2"
5.96701 645.245 "substeps=4"
10.3749 624.099 "substeps=8"
19.0759 522.094 "substeps=16"
37.3228 326.353 "substeps=32"
74.234 138.688 "substeps=64"
END
$curve13 << END
3.17059 540.038 "iterations=4"
10.9252 525.533 "iterations=16"
43.7428 482.767 "iterations=64"
END
$curve14 << END
60.7079 450.679 "iterations=64"
END
$curve15 << END
96.9024 96.8969 "iterations=1 substeps=64"
END
$default << END
9.77174 24.2658 "passes=3 iterations=2"
END
set terminal svg size 1200,760 font 'DejaVu Sans,13' background rgb 'white'
set output 'accuracy-wind-256-b-0.5s.svg'
plot $front using 1:2 with lines linewidth 9 linecolor rgb '#ffe8a3' title 'the front: nothing is cheaper and better', \
  17.6867 with lines dashtype 2 linewidth 1.2 linecolor rgb '#495057' title 'backward Euler, converged', \
  21.2304 with lines dashtype 3 linewidth 1.2 linecolor rgb '#495057' title 'BDF2, converged', \
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
  $front using 1:2:3 with labels left offset 0.8,0.6 font ',7' textcolor rgb '#343a40' noenhanced notitle, \
  $default using 1:2 with points pointtype 3 pointsize 3 linewidth 3 linecolor rgb '#000000' title 'Weft''s default'
set terminal pngcairo size 1200,760 font 'DejaVu Sans,10' background rgb 'white'
set output 'accuracy-wind-256-b-0.5s.png'
plot $front using 1:2 with lines linewidth 9 linecolor rgb '#ffe8a3' title 'the front: nothing is cheaper and better', \
  17.6867 with lines dashtype 2 linewidth 1.2 linecolor rgb '#495057' title 'backward Euler, converged', \
  21.2304 with lines dashtype 3 linewidth 1.2 linecolor rgb '#495057' title 'BDF2, converged', \
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
  $front using 1:2:3 with labels left offset 0.8,0.6 font ',7' textcolor rgb '#343a40' noenhanced notitle, \
  $default using 1:2 with points pointtype 3 pointsize 3 linewidth 3 linecolor rgb '#000000' title 'Weft''s default'
