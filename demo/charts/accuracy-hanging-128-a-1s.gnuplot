set encoding utf8
set logscale xy
set format '%g'
set border 3 linecolor rgb '#495057'
set tics nomirror
set grid xtics ytics mxtics mytics linetype 1 linewidth 1 linecolor rgb '#dde2e6', linetype 1 linewidth 0.5 linecolor rgb '#eff2f5'
set xrange [0.2471:412.272]
set yrange [3.60624:7035.79]
set title 'Sheet hung by two corners, 128 × 128 particles: distance from converged backward Euler after 1 s' noenhanced font ',13'
set xlabel 'median time of a frame of 1/60 s [ms]'
set ylabel 'RMS distance of particles [mm]'
set key outside right top Left reverse samplen 2 spacing 1.25 font ',10' noenhanced
set rmargin 42
set bmargin 8
set label 1 'AMD EPYC; 2 threads, 1 used; commit 3697fc2; κ = 9102; weft_study accuracy, then weft_study plot'."\n".'Not drawn, since they diverged: Fibres and sets in substeps iterations=1 substeps=16; Fibres and sets in substeps iterations=1 substeps=4; Fibres and sets iterations=1'."\n".' Fibres and sets iterations=16; Fibres and sets iterations=4; Jacobi (Kang): even iterations=2' at screen 0.012, screen 0.085 font ',8' textcolor rgb '#6c757d' noenhanced
$front << END
0.353 1107.14 "iterations=1"
0.47 1099.37 "iterations=3"
0.534 1082.99 "iterations=4"
0.743 1049.93 "iterations=8"
1.248 1028.73 "iterations=16"
1.263 1000.33 "iterations=16"
1.366 110.1 "iterations=1"
1.851 12.465 "passes=2 iterations=1"
2.303 7.55941 "iterations=2"
3.017 6.21337 "passes=3 iterations=2"
3.67 5.77253 "passes=4 iterations=2"
5.063 5.2828 "passes=6 iterations=2"
6.166 5.15177 "passes=8 iterations=2"
END
$curve0 << END
0.353 1107.14 "iterations=1"
0.47 1099.37 "iterations=3"
0.684 1088.79 "iterations=7"
1.168 1079.65 "iterations=15"
2.153 1074.84 "iterations=31"
4.108 1065.77 "iterations=63"
7.307 1013.14 "iterations=127"
14.242 866.02 "iterations=255"
END
$curve1 << END
0.743 1049.93 "iterations=8"
1.248 1028.73 "iterations=16"
4.124 933.993 "iterations=64"
END
$curve2 << END
0.555 1106.08 "iterations=1"
0.877 1076.23 "iterations=7"
2.305 977.737 "iterations=31"
7.929 703.511 "iterations=127"
END
$curve3 << END
1.378 1075.43 "iterations=7 substeps=2"
2.78 1006.72 "iterations=7 substeps=4"
5.391 559.001 "iterations=7 substeps=8"
10.686 128.319 "iterations=7 substeps=16"
END
$curve4 << END
0.534 1082.99 "iterations=4"
0.765 1074.44 "iterations=8"
1.263 1000.33 "iterations=16"
2.263 630.761 "iterations=32"
4.177 436.77 "iterations=64"
8.111 172.152 "iterations=128"
END
$curve5 << END
0.754 1078.78 "iterations=4"
1.245 1072.58 "iterations=8"
2.211 969.547 "iterations=16"
4.101 646.679 "iterations=32"
7.712 375.078 "iterations=64"
14.943 134.297 "iterations=128"
END
$curve6 << END
1.366 110.1 "iterations=1"
2.303 7.55941 "iterations=2"
3.368 7.87101 "iterations=4"
4.949 7.75815 "iterations=8"
END
$curve7 << END
1.851 12.465 "passes=2 iterations=1"
2.325 9.70741 "passes=2 iterations=2"
2.406 15.7892 "passes=3 iterations=1"
2.973 7.92509 "passes=2 iterations=4"
3.017 6.21337 "passes=3 iterations=2"
3.293 8.68965 "passes=4 iterations=1"
3.67 5.77253 "passes=4 iterations=2"
3.711 7.52803 "passes=3 iterations=4"
3.961 7.87117 "passes=2 iterations=6"
4.449 7.15228 "passes=6 iterations=1"
4.503 7.39958 "passes=3 iterations=6"
4.702 6.21217 "passes=4 iterations=4"
5.063 5.2828 "passes=6 iterations=2"
5.672 6.29876 "passes=8 iterations=1"
6.166 5.15177 "passes=8 iterations=2"
END
$curve8 << END
3.244 20.6513 "passes=1 substeps=2"
5.974 71.6659 "passes=1 substeps=4"
12.333 94.0312 "passes=1 substeps=8"
23.413 110.333 "passes=1 substeps=16"
END
$curve9 << END
2.709 146.314 "passes=1 iterations=2"
2.73 162.709 "passes=2 iterations=2"
3.15 162.593 "passes=3 iterations=2"
3.63 172.086 "passes=4 iterations=2"
4.375 171.196 "passes=4 iterations=4"
5.667 172.096 "passes=6 iterations=4"
END
$curve10 << END
6.349 176.667 "passes=3 substeps=2"
12.421 180.013 "passes=3 substeps=4"
24.122 180.462 "passes=3 substeps=8"
END
$curve11 << END
0.827 4397.37 "substeps=1"
1.674 4112.64 "substeps=2"
3.392 3364.08 "substeps=4"
6.746 1707.38 "substeps=8"
13.364 277.107 "substeps=16"
26.546 127.433 "substeps=32"
53.248 163.063 "substeps=64"
END
$curve12 << END
1.465 4121.63 "iterations=4"
3.835 3299.2 "iterations=16"
12.654 1501.17 "iterations=64"
END
$curve13 << END
13.033 818.299 "iterations=64"
END
$curve14 << END
56.584 182.149 "iterations=1 substeps=64"
END
$curve15 << END
58.971 179.576 "substeps=404"
107.458 179.257 "substeps=622"
201.638 179.531 "substeps=1243"
END
$curve16 << END
79.677 181.847 "substeps=404"
257.67 180.413 "substeps=1243"
END
$default << END
3.15 162.593 "passes=3 iterations=2"
END
set terminal svg size 1200,760 font 'DejaVu Sans,13' background rgb 'white'
set output 'accuracy-hanging-128-a-1s.svg'
plot $front using 1:2 with lines linewidth 9 linecolor rgb '#ffe8a3' title 'the front: nothing is cheaper and better', \
  86.3143 with lines dashtype 2 linewidth 1.2 linecolor rgb '#495057' title 'one linearisation, solved exactly', \
  $curve0 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 7 linecolor rgb '#d62728' title 'Jacobi (Kang): odd', \
  $curve1 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#f4a6a6' title 'Jacobi (Kang): even', \
  $curve2 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 9 linecolor rgb '#8c1515' title 'Jacobi (Kang) with tethers', \
  $curve3 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 8 linecolor rgb '#e8590c' title 'Jacobi (Kang) in substeps', \
  $curve4 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 5 linecolor rgb '#f59f00' title 'Chebyshev', \
  $curve5 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 13 linecolor rgb '#b8860b' title 'Conjugate gradients', \
  $curve6 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#74c0fc' title 'Multilevel: one linear solve', \
  $curve7 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 5 linecolor rgb '#0b3d91' title 'Multilevel: Newton passes', \
  $curve8 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 8 linecolor rgb '#15aabf' title 'Multilevel in substeps', \
  $curve9 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 9 linecolor rgb '#2b8a3e' title 'Multilevel: BDF2', \
  $curve10 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 11 linecolor rgb '#74b816' title 'Multilevel: BDF2 in substeps', \
  $curve11 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 7 linecolor rgb '#9c36b5' title 'XPBD: substeps', \
  $curve12 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#da77f2' title 'XPBD: iterations', \
  $curve13 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 13 linecolor rgb '#e64980' title 'Fibres and sets', \
  $curve14 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 12 linecolor rgb '#f783ac' title 'Fibres and sets in substeps', \
  $curve15 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 15 linecolor rgb '#495057' title 'Symplectic Euler', \
  $curve16 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 14 linecolor rgb '#adb5bd' title 'Explicit Euler', \
  $front using 1:2:3 with labels left offset 0.8,0.6 font ',7' textcolor rgb '#343a40' noenhanced notitle, \
  $default using 1:2 with points pointtype 3 pointsize 3 linewidth 3 linecolor rgb '#000000' title 'Weft''s default'
set terminal pngcairo size 1200,760 font 'DejaVu Sans,10' background rgb 'white'
set output 'accuracy-hanging-128-a-1s.png'
plot $front using 1:2 with lines linewidth 9 linecolor rgb '#ffe8a3' title 'the front: nothing is cheaper and better', \
  86.3143 with lines dashtype 2 linewidth 1.2 linecolor rgb '#495057' title 'one linearisation, solved exactly', \
  $curve0 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 7 linecolor rgb '#d62728' title 'Jacobi (Kang): odd', \
  $curve1 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#f4a6a6' title 'Jacobi (Kang): even', \
  $curve2 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 9 linecolor rgb '#8c1515' title 'Jacobi (Kang) with tethers', \
  $curve3 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 8 linecolor rgb '#e8590c' title 'Jacobi (Kang) in substeps', \
  $curve4 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 5 linecolor rgb '#f59f00' title 'Chebyshev', \
  $curve5 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 13 linecolor rgb '#b8860b' title 'Conjugate gradients', \
  $curve6 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#74c0fc' title 'Multilevel: one linear solve', \
  $curve7 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 5 linecolor rgb '#0b3d91' title 'Multilevel: Newton passes', \
  $curve8 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 8 linecolor rgb '#15aabf' title 'Multilevel in substeps', \
  $curve9 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 9 linecolor rgb '#2b8a3e' title 'Multilevel: BDF2', \
  $curve10 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 11 linecolor rgb '#74b816' title 'Multilevel: BDF2 in substeps', \
  $curve11 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 7 linecolor rgb '#9c36b5' title 'XPBD: substeps', \
  $curve12 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#da77f2' title 'XPBD: iterations', \
  $curve13 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 13 linecolor rgb '#e64980' title 'Fibres and sets', \
  $curve14 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 12 linecolor rgb '#f783ac' title 'Fibres and sets in substeps', \
  $curve15 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 15 linecolor rgb '#495057' title 'Symplectic Euler', \
  $curve16 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 14 linecolor rgb '#adb5bd' title 'Explicit Euler', \
  $front using 1:2:3 with labels left offset 0.8,0.6 font ',7' textcolor rgb '#343a40' noenhanced notitle, \
  $default using 1:2 with points pointtype 3 pointsize 3 linewidth 3 linecolor rgb '#000000' title 'Weft''s default'
