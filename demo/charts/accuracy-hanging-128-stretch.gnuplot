set encoding utf8
set logscale xy
set format '%g'
set border 3 linecolor rgb '#495057'
set tics nomirror
set grid xtics ytics mxtics mytics linetype 1 linewidth 1 linecolor rgb '#dde2e6', linetype 1 linewidth 0.5 linecolor rgb '#eff2f5'
set xrange [0.289804:863.368]
set yrange [3.08899:46306.9]
set title 'Sheet hung by two corners, 128 × 128 particles: worst stretch of a thread after 1 s' noenhanced font ',13'
set xlabel 'median time of a frame of 1/60 s [ms]'
set ylabel 'worst stretch [%]'
set key outside right top Left reverse samplen 2 spacing 1.25 font ',10' noenhanced
set rmargin 42
set bmargin 8
set label 1 'Intel(R) Xeon(R) Processor; 2 threads, 2 used; commit 05b8bef; κ = 9102; weft_study accuracy, then weft_study plot'."\n".'Not drawn, since they diverged: Fibres and sets in substeps iterations=1 substeps=4; Fibres and sets iterations=1; Fibres and sets iterations=4' at screen 0.012, screen 0.085 font ',8' textcolor rgb '#6c757d' noenhanced
$curve0 << END
0.465065 509.984 "iterations=1"
0.591411 542.701 "iterations=3"
0.852744 668.621 "iterations=7"
1.23069 676.142 "iterations=15"
2.048 755.907 "iterations=31"
3.60433 710.896 "iterations=63"
7.21014 329.619 "iterations=127"
14.4253 146.021 "iterations=255"
END
$curve1 << END
0.502672 6791 "iterations=2"
0.833343 788.88 "iterations=8"
1.27275 819.163 "iterations=16"
4.04322 707.924 "iterations=64"
END
$curve2 << END
0.59482 76.7071 "iterations=1"
0.913963 28.0749 "iterations=7"
2.32295 10.811 "iterations=31"
7.78924 4.41285 "iterations=127"
END
$curve3 << END
1.76172 738.361 "iterations=7 substeps=2"
3.50398 522.959 "iterations=7 substeps=4"
6.21934 339.358 "iterations=7 substeps=8"
12.4877 41.3103 "iterations=7 substeps=16"
END
$curve4 << END
0.649131 252.662 "iterations=4"
0.908507 282.992 "iterations=8"
1.44532 266.938 "iterations=16"
2.35863 63.7067 "iterations=32"
4.0759 19.5552 "iterations=64"
7.77975 16.9067 "iterations=128"
END
$curve5 << END
0.755605 475.588 "iterations=4"
1.06146 396.459 "iterations=8"
1.90618 272.833 "iterations=16"
3.51245 48.4883 "iterations=32"
6.6772 20.9824 "iterations=64"
13.1103 17.5293 "iterations=128"
END
$curve6 << END
1.43931 25.5094 "iterations=1"
2.00019 12.7766 "iterations=2"
2.86988 13.1586 "iterations=3"
3.2641 13.3168 "iterations=4"
4.32998 14.6342 "iterations=6"
5.82313 16.1683 "iterations=8"
9.01844 14.55 "iterations=12"
10.7708 14.9225 "iterations=16"
END
$curve7 << END
1.15741 109.993 "iterations=1"
1.60397 12.3645 "iterations=2"
2.54307 13.2513 "iterations=4"
4.21056 13.2999 "iterations=8"
END
$curve8 << END
1.8752 12.2348 "passes=2 iterations=1"
2.46583 14.5663 "passes=2 iterations=2"
2.60058 14.0856 "passes=3 iterations=1"
2.94979 13.8547 "passes=3 iterations=2"
3.19455 14.6019 "passes=2 iterations=4"
3.48598 14.4888 "passes=4 iterations=2"
3.48656 13.0544 "passes=4 iterations=1"
3.93078 14.3875 "passes=3 iterations=4"
4.15695 14.731 "passes=2 iterations=6"
4.22556 14.5154 "passes=4 iterations=4"
4.65287 13.7431 "passes=6 iterations=1"
4.781 14.8284 "passes=3 iterations=6"
4.87463 14.9958 "passes=6 iterations=2"
5.84126 14.4985 "passes=8 iterations=1"
6.02405 14.9185 "passes=8 iterations=2"
END
$curve9 << END
2.24711 13.5966 "passes=1 substeps=2"
4.64244 16.5352 "passes=1 substeps=4"
8.87883 16.1206 "passes=1 substeps=8"
18.1652 14.2867 "passes=1 substeps=16"
END
$curve10 << END
1.59854 76.4908 "passes=1 iterations=2"
2.2398 18.4534 "passes=2 iterations=2"
2.86257 14.5535 "passes=3 iterations=2"
3.52377 12.5071 "passes=4 iterations=2"
4.1946 9.97286 "passes=4 iterations=4"
5.58354 9.36121 "passes=6 iterations=4"
END
$curve11 << END
5.24007 10.6977 "passes=3 substeps=2"
9.98607 15.9237 "passes=3 substeps=4"
22.3543 12.6117 "passes=3 substeps=8"
END
$curve12 << END
0.414006 28941.8 "substeps=1"
0.768458 23250.9 "substeps=2"
1.42494 15234.5 "substeps=4"
2.88871 3515.68 "substeps=8"
5.79232 528.216 "substeps=16"
11.2353 91.5916 "substeps=32"
18.7997 42.2005 "substeps=64"
END
$curve13 << END
1.19808 23205.2 "iterations=4"
4.34258 14561.8 "iterations=16"
17.1888 2606.56 "iterations=64"
END
$curve14 << END
4.47796 13742.1 "iterations=16"
16.2871 1823.95 "iterations=64"
END
$curve15 << END
6.16308 390.343 "iterations=1 substeps=16"
24.5395 29.4972 "iterations=1 substeps=64"
END
$curve16 << END
3.8042 32.3857 "passes=1 iterations=2"
5.22687 29.3432 "passes=2 iterations=2"
7.05957 28.5412 "passes=3 iterations=2"
8.83988 27.9626 "passes=4 iterations=2"
11.7445 29.1796 "passes=6 iterations=2"
END
$curve17 << END
111.698 13.1371 "substeps=740"
151.545 13.8643 "substeps=1138"
312.563 15.0088 "substeps=2276"
END
$curve18 << END
144.763 15.5173 "substeps=740"
539.605 13.3544 "substeps=2276"
END
$default << END
2.94979 13.8547 "passes=3 iterations=2"
END
set terminal svg size 1200,760 font 'DejaVu Sans,13' background rgb 'white'
set output 'accuracy-hanging-128-stretch.svg'
plot 13.8574 with lines dashtype 2 linewidth 1.2 linecolor rgb '#495057' title 'the true motion (tiny steps)', \
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
  $curve16 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 4 linecolor rgb '#087f5b' title 'Multilevel: finite elements', \
  $curve17 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 15 linecolor rgb '#495057' title 'Symplectic Euler', \
  $curve18 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 14 linecolor rgb '#adb5bd' title 'Explicit Euler', \
  $default using 1:2 with points pointtype 3 pointsize 3 linewidth 3 linecolor rgb '#000000' title 'Weft''s default'
set terminal pngcairo size 1200,760 font 'DejaVu Sans,10' background rgb 'white'
set output 'accuracy-hanging-128-stretch.png'
plot 13.8574 with lines dashtype 2 linewidth 1.2 linecolor rgb '#495057' title 'the true motion (tiny steps)', \
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
  $curve16 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 4 linecolor rgb '#087f5b' title 'Multilevel: finite elements', \
  $curve17 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 15 linecolor rgb '#495057' title 'Symplectic Euler', \
  $curve18 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 14 linecolor rgb '#adb5bd' title 'Explicit Euler', \
  $default using 1:2 with points pointtype 3 pointsize 3 linewidth 3 linecolor rgb '#000000' title 'Weft''s default'
