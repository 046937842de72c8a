set encoding utf8
set logscale xy
set format '%g'
set border 3 linecolor rgb '#495057'
set tics nomirror
set grid xtics ytics mxtics mytics linetype 1 linewidth 1 linecolor rgb '#dde2e6', linetype 1 linewidth 0.5 linecolor rgb '#eff2f5'
set xrange [0.0793037:351.134]
set yrange [10.022:115.849]
set ytics (20, 50, 100)
set title 'T-shirt hung by its neck, 3546 particles: worst stretch of a thread after 1 s' noenhanced font ',13'
set xlabel 'median time of a frame of 1/60 s [ms]'
set ylabel 'worst stretch [%]'
set key outside right top Left reverse samplen 2 spacing 1.25 font ',10' noenhanced
set rmargin 42
set bmargin 5
set label 1 'Intel(R) Xeon(R) Processor; 2 threads, 2 used; commit 05b8bef; κ = 2923; weft_study accuracy, then weft_study plot' at screen 0.012, screen 0.022 font ',8' textcolor rgb '#6c757d' noenhanced
$curve0 << END
0.125949 26.6884 "iterations=1"
0.174391 26.6287 "iterations=3"
0.252714 23.8148 "iterations=7"
0.415928 21.1504 "iterations=15"
0.729599 18.8027 "iterations=31"
1.40783 17.9947 "iterations=63"
2.75852 17.8365 "iterations=127"
5.41597 16.7495 "iterations=255"
END
$curve1 << END
0.152594 47.7469 "iterations=2"
0.270642 31.9555 "iterations=8"
0.430389 24.1879 "iterations=16"
1.19549 17.8087 "iterations=64"
END
$curve2 << END
0.14421 26.6884 "iterations=1"
0.277542 23.8148 "iterations=7"
0.708593 18.8027 "iterations=31"
2.71029 17.8365 "iterations=127"
END
$curve3 << END
0.474937 25.8273 "iterations=7 substeps=2"
0.894672 14.5267 "iterations=7 substeps=4"
1.88946 14.5268 "iterations=7 substeps=8"
3.74455 14.5066 "iterations=7 substeps=16"
END
$curve4 << END
0.191915 25.5476 "iterations=4"
0.274643 19.7663 "iterations=8"
0.438625 21.6787 "iterations=16"
0.660742 19.228 "iterations=32"
1.44798 14.4258 "iterations=64"
2.58303 14.3788 "iterations=128"
END
$curve5 << END
0.233537 26.5771 "iterations=4"
0.381897 20.8156 "iterations=8"
0.721393 19.5262 "iterations=16"
1.29758 15.4215 "iterations=32"
2.50704 14.4067 "iterations=64"
4.65851 14.3172 "iterations=128"
END
$curve6 << END
0.412286 14.5243 "iterations=1"
0.597027 14.5098 "iterations=2"
0.855724 14.5045 "iterations=3"
0.970914 14.4831 "iterations=4"
1.40921 14.454 "iterations=6"
1.89388 14.4118 "iterations=8"
2.34817 14.396 "iterations=12"
3.2817 14.3921 "iterations=16"
END
$curve7 << END
0.321035 14.5243 "iterations=1"
0.497153 14.4807 "iterations=2"
0.695462 14.4116 "iterations=4"
1.09536 14.4348 "iterations=8"
END
$curve8 << END
0.491038 14.5007 "passes=2 iterations=1"
0.601608 14.472 "passes=2 iterations=2"
0.726541 14.4782 "passes=3 iterations=1"
0.745062 14.443 "passes=3 iterations=2"
0.89962 14.4509 "passes=4 iterations=1"
0.924697 14.4117 "passes=2 iterations=4"
1.06195 14.4164 "passes=4 iterations=2"
1.11333 14.41 "passes=3 iterations=4"
1.2172 14.4266 "passes=2 iterations=6"
1.35027 14.4151 "passes=4 iterations=4"
1.35485 14.4231 "passes=6 iterations=1"
1.4084 14.43 "passes=3 iterations=6"
1.43671 14.3954 "passes=6 iterations=2"
1.55434 14.4105 "passes=8 iterations=1"
1.709 14.3926 "passes=8 iterations=2"
END
$curve9 << END
0.607535 14.5003 "passes=1 substeps=2"
1.16467 14.4562 "passes=1 substeps=4"
2.32605 14.4042 "passes=1 substeps=8"
4.70879 14.3802 "passes=1 substeps=16"
END
$curve10 << END
0.113291 33.0231 "substeps=1"
0.203121 31.9962 "substeps=2"
0.392712 38.4843 "substeps=4"
0.753485 41.0793 "substeps=8"
1.51645 38.2326 "substeps=16"
2.9834 30.6306 "substeps=32"
6.32109 22.7524 "substeps=64"
END
$curve11 << END
0.34145 42.0718 "iterations=4"
1.53219 41.0266 "iterations=16"
4.21857 40.3117 "iterations=64"
END
$curve12 << END
0.222708 64.9199 "iterations=1"
0.704866 72.4055 "iterations=4"
2.71466 48.0339 "iterations=16"
11.4883 66.896 "iterations=64"
END
$curve13 << END
0.817958 38.0543 "iterations=1 substeps=4"
3.62119 44.3116 "iterations=1 substeps=16"
13.4996 17.5483 "iterations=1 substeps=64"
END
$curve14 << END
29.9501 14.3863 "substeps=641"
43.7698 14.3855 "substeps=985"
87.6725 14.3822 "substeps=1970"
END
$curve15 << END
40.6327 14.3869 "substeps=641"
125.118 14.3825 "substeps=1970"
END
$curve16 << END
219.459 14.3235 "one factorisation a step"
END
$default << END
0.745062 14.443 "passes=3 iterations=2"
END
set terminal svg size 1200,760 font 'DejaVu Sans,13' background rgb 'white'
set output 'accuracy-tshirt-stretch.svg'
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
  $curve16 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 2 linecolor rgb '#000000' title 'Sparse Cholesky', \
  $default using 1:2 with points pointtype 3 pointsize 3 linewidth 3 linecolor rgb '#000000' title 'Weft''s default'
set terminal pngcairo size 1200,760 font 'DejaVu Sans,10' background rgb 'white'
set output 'accuracy-tshirt-stretch.png'
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
  $curve16 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 2 linecolor rgb '#000000' title 'Sparse Cholesky', \
  $default using 1:2 with points pointtype 3 pointsize 3 linewidth 3 linecolor rgb '#000000' title 'Weft''s default'
