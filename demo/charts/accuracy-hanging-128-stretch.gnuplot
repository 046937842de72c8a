set encoding utf8
set logscale xy
set format '%g'
set border 3 linecolor rgb '#495057'
set tics nomirror
set grid xtics ytics mxtics mytics linetype 1 linewidth 1 linecolor rgb '#dde2e6', linetype 1 linewidth 0.5 linecolor rgb '#eff2f5'
set xrange [0.151685:488.046]
set yrange [2.43233:46306.9]
set title 'Sheet hung by two corners, 128 × 128 particles: worst stretch of a thread after 1 s' noenhanced font ',13'
set xlabel 'median time of a frame of 1/60 s [ms]'
set ylabel 'worst stretch [%]'
set key outside right top Left reverse samplen 2 spacing 1.25 font ',10' noenhanced
set rmargin 42
set bmargin 8
set label 1 'Intel(R) Xeon(R) Processor; 2 threads, 2 used; commit d3fa699; κ = 9102; weft_study accuracy, then weft_study plot'."\n".'Not drawn, since they diverged: Fibres and sets in substeps iterations=1 substeps=4; Fibres and sets iterations=1; Fibres and sets iterations=4' at screen 0.012, screen 0.085 font ',8' textcolor rgb '#6c757d' noenhanced
$curve0 << END
0.216693 510.18 "iterations=1"
0.279262 542.897 "iterations=3"
0.419752 663.191 "iterations=7"
0.698912 677.436 "iterations=15"
1.23418 755.451 "iterations=31"
2.31587 710.377 "iterations=63"
4.50977 329.662 "iterations=127"
8.84034 146.134 "iterations=255"
END
$curve1 << END
0.243842 3044.88 "iterations=2"
0.445317 778.242 "iterations=8"
0.723137 857.784 "iterations=16"
2.36341 728.713 "iterations=64"
END
$curve2 << END
0.337469 51.6478 "iterations=1"
0.518117 45.858 "iterations=7"
1.3432 9.61003 "iterations=31"
4.60211 3.47476 "iterations=127"
END
$curve3 << END
0.805101 741.188 "iterations=7 substeps=2"
1.58808 523.522 "iterations=7 substeps=4"
3.13285 316.777 "iterations=7 substeps=8"
6.24098 43.5581 "iterations=7 substeps=16"
END
$curve4 << END
0.339211 248.751 "iterations=4"
0.477241 285.627 "iterations=8"
0.753408 290.754 "iterations=16"
1.3116 108.916 "iterations=32"
2.44876 18.9025 "iterations=64"
4.63903 17.2339 "iterations=128"
END
$curve5 << END
0.456711 477.122 "iterations=4"
0.794317 410.633 "iterations=8"
1.47193 291.263 "iterations=16"
2.88713 28.3252 "iterations=32"
5.46511 21.0858 "iterations=64"
10.8558 17.4728 "iterations=128"
END
$curve6 << END
0.764718 35.3643 "iterations=1"
1.08006 13.2181 "iterations=2"
1.42982 13.6443 "iterations=3"
1.79259 12.7838 "iterations=4"
2.50472 15.2183 "iterations=6"
3.20154 12.6606 "iterations=8"
4.54373 15.3114 "iterations=12"
6.00487 16.2232 "iterations=16"
END
$curve7 << END
0.632331 16.1031 "iterations=1"
0.891182 12.5387 "iterations=2"
1.34027 13.2841 "iterations=4"
2.312 12.9045 "iterations=8"
END
$curve8 << END
0.973768 12.2005 "passes=2 iterations=1"
1.23265 14.4699 "passes=2 iterations=2"
1.28858 14.1547 "passes=3 iterations=1"
1.54648 12.9925 "passes=4 iterations=1"
1.58368 13.9921 "passes=3 iterations=2"
1.69862 14.5325 "passes=2 iterations=4"
1.79808 14.3892 "passes=4 iterations=2"
1.95368 14.3752 "passes=3 iterations=4"
2.14581 14.7268 "passes=2 iterations=6"
2.14725 13.8804 "passes=6 iterations=1"
2.27262 14.6848 "passes=4 iterations=4"
2.37372 15.0011 "passes=6 iterations=2"
2.45431 14.8341 "passes=3 iterations=6"
2.73725 14.3653 "passes=8 iterations=1"
2.95453 14.8146 "passes=8 iterations=2"
END
$curve9 << END
1.25758 13.2993 "passes=1 substeps=2"
2.46038 16.6697 "passes=1 substeps=4"
4.85454 15.8088 "passes=1 substeps=8"
9.76098 13.8926 "passes=1 substeps=16"
END
$curve10 << END
0.923378 100.98 "passes=1 iterations=2"
1.22708 18.9813 "passes=2 iterations=2"
1.51016 13.8754 "passes=3 iterations=2"
1.81101 12.4378 "passes=4 iterations=2"
2.27475 9.21673 "passes=4 iterations=4"
2.92165 8.68853 "passes=6 iterations=4"
END
$curve11 << END
3.03902 10.366 "passes=3 substeps=2"
6.02111 15.9495 "passes=3 substeps=4"
12.0799 11.2993 "passes=3 substeps=8"
END
$curve12 << END
3.16163 32.3844 "passes=1 iterations=2"
4.46647 29.3428 "passes=2 iterations=2"
5.76323 28.542 "passes=3 iterations=2"
7.10005 27.9581 "passes=4 iterations=2"
9.78599 29.1777 "passes=6 iterations=2"
END
$curve13 << END
0.266435 28941.8 "substeps=1"
0.508128 23250.9 "substeps=2"
1.02194 15234.5 "substeps=4"
2.01541 3515.68 "substeps=8"
3.93461 528.216 "substeps=16"
7.75683 91.5916 "substeps=32"
15.6114 42.2005 "substeps=64"
END
$curve14 << END
0.787649 23205.2 "iterations=4"
2.79608 14561.8 "iterations=16"
10.7913 2606.56 "iterations=64"
END
$curve15 << END
3.77608 13742.1 "iterations=16"
14.6722 1823.95 "iterations=64"
END
$curve16 << END
5.27618 390.343 "iterations=1 substeps=16"
20.8829 29.4972 "iterations=1 substeps=64"
END
$curve17 << END
59.2705 14.3006 "substeps=740"
95.0678 13.5747 "substeps=1138"
182.845 15.6508 "substeps=2276"
END
$curve18 << END
103.519 14.1876 "substeps=740"
305.029 14.3677 "substeps=2276"
END
$default << END
1.58368 13.9921 "passes=3 iterations=2"
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
  $curve12 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 4 linecolor rgb '#087f5b' title 'Multilevel: finite elements', \
  $curve13 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 7 linecolor rgb '#9c36b5' title 'XPBD: substeps', \
  $curve14 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#da77f2' title 'XPBD: iterations', \
  $curve15 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 13 linecolor rgb '#e64980' title 'Fibres and sets', \
  $curve16 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 12 linecolor rgb '#f783ac' title 'Fibres and sets in substeps', \
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
  $curve12 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 4 linecolor rgb '#087f5b' title 'Multilevel: finite elements', \
  $curve13 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 7 linecolor rgb '#9c36b5' title 'XPBD: substeps', \
  $curve14 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#da77f2' title 'XPBD: iterations', \
  $curve15 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 13 linecolor rgb '#e64980' title 'Fibres and sets', \
  $curve16 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 12 linecolor rgb '#f783ac' title 'Fibres and sets in substeps', \
  $curve17 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 15 linecolor rgb '#495057' title 'Symplectic Euler', \
  $curve18 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 14 linecolor rgb '#adb5bd' title 'Explicit Euler', \
  $default using 1:2 with points pointtype 3 pointsize 3 linewidth 3 linecolor rgb '#000000' title 'Weft''s default'
