set encoding utf8
set logscale xy
set format '%g'
set border 3 linecolor rgb '#495057'
set tics nomirror
set grid xtics ytics mxtics mytics linetype 1 linewidth 1 linecolor rgb '#dde2e6', linetype 1 linewidth 0.5 linecolor rgb '#eff2f5'
set xrange [0.151685:488.046]
set yrange [2.61403:6883.07]
set title 'Sheet hung by two corners, 128 × 128 particles: distance from converged backward Euler after 1 s' noenhanced font ',13'
set xlabel 'median time of a frame of 1/60 s [ms]'
set ylabel 'RMS distance of particles [mm]'
set key outside right top Left reverse samplen 2 spacing 1.25 font ',10' noenhanced
set rmargin 42
set bmargin 8
set label 1 'Intel(R) Xeon(R) Processor; 2 threads, 2 used; commit d3fa699; κ = 9102; weft_study accuracy, then weft_study plot'."\n".'Not drawn, since they diverged: Fibres and sets in substeps iterations=1 substeps=4; Fibres and sets iterations=1; Fibres and sets iterations=4' at screen 0.012, screen 0.085 font ',8' textcolor rgb '#6c757d' noenhanced
$front << END
0.216693 1089.64 "iterations=1"
0.337469 983.637 "iterations=1"
0.518117 845.007 "iterations=7"
0.632331 118.568 "iterations=1"
0.891182 43.1874 "iterations=2"
0.973768 34.1624 "passes=2 iterations=1"
1.08006 28.7416 "iterations=2"
1.23265 14.3582 "passes=2 iterations=2"
1.58368 8.64396 "passes=3 iterations=2"
1.69862 8.42343 "passes=2 iterations=4"
1.79808 7.39914 "passes=4 iterations=2"
1.95368 5.84109 "passes=3 iterations=4"
2.27262 5.29535 "passes=4 iterations=4"
2.45431 3.73433 "passes=3 iterations=6"
END
$curve0 << END
0.216693 1089.64 "iterations=1"
0.279262 1108.74 "iterations=3"
0.419752 1149.23 "iterations=7"
0.698912 1166.88 "iterations=15"
1.23418 1166.36 "iterations=31"
2.31587 1136.19 "iterations=63"
4.50977 998.421 "iterations=127"
8.84034 827.893 "iterations=255"
END
$curve1 << END
0.243842 1121.69 "iterations=2"
0.445317 1162.11 "iterations=8"
0.723137 1181.83 "iterations=16"
2.36341 1110.66 "iterations=64"
END
$curve2 << END
0.337469 983.637 "iterations=1"
0.518117 845.007 "iterations=7"
1.3432 735.656 "iterations=31"
4.60211 616.776 "iterations=127"
END
$curve3 << END
0.805101 1153.43 "iterations=7 substeps=2"
1.58808 965.879 "iterations=7 substeps=4"
3.13285 514.359 "iterations=7 substeps=8"
6.24098 138.855 "iterations=7 substeps=16"
END
$curve4 << END
0.339211 1087.49 "iterations=4"
0.477241 1065.12 "iterations=8"
0.753408 947.487 "iterations=16"
1.3116 665.732 "iterations=32"
2.44876 440.022 "iterations=64"
4.63903 190.271 "iterations=128"
END
$curve5 << END
0.456711 1120.6 "iterations=4"
0.794317 1093.58 "iterations=8"
1.47193 945.535 "iterations=16"
2.88713 684.243 "iterations=32"
5.46511 413.448 "iterations=64"
10.8558 168.204 "iterations=128"
END
$curve6 << END
0.764718 119.568 "iterations=1"
1.08006 28.7416 "iterations=2"
1.42982 28.0448 "iterations=3"
1.79259 25.3576 "iterations=4"
2.50472 20.0267 "iterations=6"
3.20154 27.1419 "iterations=8"
4.54373 13.8758 "iterations=12"
6.00487 9.72429 "iterations=16"
END
$curve7 << END
0.632331 118.568 "iterations=1"
0.891182 43.1874 "iterations=2"
1.34027 32.6341 "iterations=4"
2.312 56.5468 "iterations=8"
END
$curve8 << END
0.973768 34.1624 "passes=2 iterations=1"
1.23265 14.3582 "passes=2 iterations=2"
1.28858 24.0264 "passes=3 iterations=1"
1.54648 15.7848 "passes=4 iterations=1"
1.58368 8.64396 "passes=3 iterations=2"
1.69862 8.42343 "passes=2 iterations=4"
1.79808 7.39914 "passes=4 iterations=2"
1.95368 5.84109 "passes=3 iterations=4"
2.14581 6.13824 "passes=2 iterations=6"
2.14725 8.39478 "passes=6 iterations=1"
2.27262 5.29535 "passes=4 iterations=4"
2.37372 5.74261 "passes=6 iterations=2"
2.45431 3.73433 "passes=3 iterations=6"
2.73725 7.79787 "passes=8 iterations=1"
2.95453 5.44627 "passes=8 iterations=2"
END
$curve9 << END
1.25758 39.2675 "passes=1 substeps=2"
2.46038 56.0836 "passes=1 substeps=4"
4.85454 88.2473 "passes=1 substeps=8"
9.76098 113.611 "passes=1 substeps=16"
END
$curve10 << END
0.923378 176.934 "passes=1 iterations=2"
1.22708 170.376 "passes=2 iterations=2"
1.51016 163.312 "passes=3 iterations=2"
1.81101 169.13 "passes=4 iterations=2"
2.27475 170.427 "passes=4 iterations=4"
2.92165 173.207 "passes=6 iterations=4"
END
$curve11 << END
3.03902 170.17 "passes=3 substeps=2"
6.02111 178.161 "passes=3 substeps=4"
12.0799 181.211 "passes=3 substeps=8"
END
$curve12 << END
0.266435 4301.92 "substeps=1"
0.508128 3825.85 "substeps=2"
1.02194 2649.63 "substeps=4"
2.01541 883.424 "substeps=8"
3.93461 162.378 "substeps=16"
7.75683 138.68 "substeps=32"
15.6114 169.76 "substeps=64"
END
$curve13 << END
0.787649 3821.97 "iterations=4"
2.79608 2534.21 "iterations=16"
10.7913 717.493 "iterations=64"
END
$curve14 << END
3.77608 1956.71 "iterations=16"
14.6722 355.578 "iterations=64"
END
$curve15 << END
5.27618 127.89 "iterations=1 substeps=16"
20.8829 182.143 "iterations=1 substeps=64"
END
$curve16 << END
59.2705 180.429 "substeps=740"
95.0678 179.722 "substeps=1138"
182.845 179.534 "substeps=2276"
END
$curve17 << END
103.519 182.237 "substeps=740"
305.029 180.449 "substeps=2276"
END
$default << END
1.58368 8.64396 "passes=3 iterations=2"
END
set terminal svg size 1200,760 font 'DejaVu Sans,13' background rgb 'white'
set output 'accuracy-hanging-128-a-1s.svg'
plot $front using 1:2 with lines linewidth 9 linecolor rgb '#ffe8a3' title 'the front: nothing is cheaper and better', \
  96.9489 with lines dashtype 2 linewidth 1.2 linecolor rgb '#495057' title 'one linearisation, solved exactly', \
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
  96.9489 with lines dashtype 2 linewidth 1.2 linecolor rgb '#495057' title 'one linearisation, solved exactly', \
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
