set encoding utf8
set logscale xy
set format '%g'
set border 3 linecolor rgb '#495057'
set tics nomirror
set grid xtics ytics mxtics mytics linetype 1 linewidth 1 linecolor rgb '#dde2e6', linetype 1 linewidth 0.5 linecolor rgb '#eff2f5'
set xrange [0.151685:488.046]
set yrange [1.50978:1488.07]
set title 'Sheet hung by two corners, 128 × 128 particles: distance from the true motion (tiny steps) after 0.5 s' noenhanced font ',13'
set xlabel 'median time of a frame of 1/60 s [ms]'
set ylabel 'RMS distance of particles [mm]'
set key outside right top Left reverse samplen 2 spacing 1.25 font ',10' noenhanced
set rmargin 42
set bmargin 8
set label 1 'Intel(R) Xeon(R) Processor; 2 threads, 2 used; commit d3fa699; κ = 9102; weft_study accuracy, then weft_study plot'."\n".'Not drawn, since they diverged: Fibres and sets in substeps iterations=1 substeps=4; Fibres and sets iterations=1; Fibres and sets iterations=4' at screen 0.012, screen 0.085 font ',8' textcolor rgb '#6c757d' noenhanced
$front << END
0.216693 713.257 "iterations=1"
0.243842 701.062 "iterations=2"
0.279262 686.128 "iterations=3"
0.419752 651.8 "iterations=7"
0.518117 604.066 "iterations=7"
0.632331 64.8499 "iterations=1"
0.891182 51.3197 "iterations=2"
0.923378 45.3204 "passes=1 iterations=2"
1.22708 23.1968 "passes=2 iterations=2"
1.51016 22.0989 "passes=3 iterations=2"
1.81101 21.6319 "passes=4 iterations=2"
2.27475 19.8768 "passes=4 iterations=4"
2.92165 18.9822 "passes=6 iterations=4"
3.03902 11.5665 "passes=3 substeps=2"
6.02111 7.30744 "passes=3 substeps=4"
12.0799 4.81537 "passes=3 substeps=8"
59.2705 2.35335 "substeps=740"
95.0678 2.15683 "substeps=1138"
END
$curve0 << END
0.216693 713.257 "iterations=1"
0.279262 686.128 "iterations=3"
0.419752 651.8 "iterations=7"
0.698912 628.775 "iterations=15"
1.23418 611.168 "iterations=31"
2.31587 605.546 "iterations=63"
4.50977 613.409 "iterations=127"
8.84034 595.592 "iterations=255"
END
$curve1 << END
0.243842 701.062 "iterations=2"
0.445317 653.105 "iterations=8"
0.723137 629.421 "iterations=16"
2.36341 603.025 "iterations=64"
END
$curve2 << END
0.337469 709.971 "iterations=1"
0.518117 604.066 "iterations=7"
1.3432 525.958 "iterations=31"
4.60211 487.97 "iterations=127"
END
$curve3 << END
0.805101 612.398 "iterations=7 substeps=2"
1.58808 594.098 "iterations=7 substeps=4"
3.13285 498.595 "iterations=7 substeps=8"
6.24098 355.807 "iterations=7 substeps=16"
END
$curve4 << END
0.339211 702.202 "iterations=4"
0.477241 675.073 "iterations=8"
0.753408 621.249 "iterations=16"
1.3116 545.393 "iterations=32"
2.44876 385.254 "iterations=64"
4.63903 207.341 "iterations=128"
END
$curve5 << END
0.456711 672.093 "iterations=4"
0.794317 647.796 "iterations=8"
1.47193 595.997 "iterations=16"
2.88713 530.378 "iterations=32"
5.46511 364.235 "iterations=64"
10.8558 151.964 "iterations=128"
END
$curve6 << END
0.764718 120.446 "iterations=1"
1.08006 71.4661 "iterations=2"
1.42982 65.467 "iterations=3"
1.79259 77.3382 "iterations=4"
2.50472 71.0738 "iterations=6"
3.20154 72.2098 "iterations=8"
4.54373 65.661 "iterations=12"
6.00487 63.1179 "iterations=16"
END
$curve7 << END
0.632331 64.8499 "iterations=1"
0.891182 51.3197 "iterations=2"
1.34027 50.1098 "iterations=4"
2.312 81.0422 "iterations=8"
END
$curve8 << END
0.973768 59.2121 "passes=2 iterations=1"
1.23265 35.4989 "passes=2 iterations=2"
1.28858 41.9041 "passes=3 iterations=1"
1.54648 44.0877 "passes=4 iterations=1"
1.58368 38.1773 "passes=3 iterations=2"
1.69862 41.3895 "passes=2 iterations=4"
1.79808 39.0772 "passes=4 iterations=2"
1.95368 39.3374 "passes=3 iterations=4"
2.14581 39.5964 "passes=2 iterations=6"
2.14725 40.3189 "passes=6 iterations=1"
2.27262 38.3222 "passes=4 iterations=4"
2.37372 38.0844 "passes=6 iterations=2"
2.45431 38.3052 "passes=3 iterations=6"
2.73725 40.3609 "passes=8 iterations=1"
2.95453 38.0017 "passes=8 iterations=2"
END
$curve9 << END
1.25758 34.4752 "passes=1 substeps=2"
2.46038 26.0776 "passes=1 substeps=4"
4.85454 16.2717 "passes=1 substeps=8"
9.76098 11.1298 "passes=1 substeps=16"
END
$curve10 << END
0.923378 45.3204 "passes=1 iterations=2"
1.22708 23.1968 "passes=2 iterations=2"
1.51016 22.0989 "passes=3 iterations=2"
1.81101 21.6319 "passes=4 iterations=2"
2.27475 19.8768 "passes=4 iterations=4"
2.92165 18.9822 "passes=6 iterations=4"
END
$curve11 << END
3.03902 11.5665 "passes=3 substeps=2"
6.02111 7.30744 "passes=3 substeps=4"
12.0799 4.81537 "passes=3 substeps=8"
END
$curve12 << END
0.266435 930.046 "substeps=1"
0.508128 887.683 "substeps=2"
1.02194 802.674 "substeps=4"
2.01541 633.9 "substeps=8"
3.93461 388.454 "substeps=16"
7.75683 175.378 "substeps=32"
15.6114 80.7652 "substeps=64"
END
$curve13 << END
0.787649 896.345 "iterations=4"
2.79608 801.377 "iterations=16"
10.7913 594.737 "iterations=64"
END
$curve14 << END
3.77608 748.717 "iterations=16"
14.6722 506.883 "iterations=64"
END
$curve15 << END
5.27618 312.015 "iterations=1 substeps=16"
20.8829 43.3725 "iterations=1 substeps=64"
END
$curve16 << END
59.2705 2.35335 "substeps=740"
95.0678 2.15683 "substeps=1138"
182.845 3.50506 "substeps=2276"
END
$curve17 << END
103.519 3.62454 "substeps=740"
305.029 3.4329 "substeps=2276"
END
$default << END
1.58368 38.1773 "passes=3 iterations=2"
END
set terminal svg size 1200,760 font 'DejaVu Sans,13' background rgb 'white'
set output 'accuracy-hanging-128-b-0.5s.svg'
plot $front using 1:2 with lines linewidth 9 linecolor rgb '#ffe8a3' title 'the front: nothing is cheaper and better', \
  37.5372 with lines dashtype 2 linewidth 1.2 linecolor rgb '#495057' title 'backward Euler, converged', \
  19.051 with lines dashtype 3 linewidth 1.2 linecolor rgb '#495057' title 'BDF2, converged', \
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
set output 'accuracy-hanging-128-b-0.5s.png'
plot $front using 1:2 with lines linewidth 9 linecolor rgb '#ffe8a3' title 'the front: nothing is cheaper and better', \
  37.5372 with lines dashtype 2 linewidth 1.2 linecolor rgb '#495057' title 'backward Euler, converged', \
  19.051 with lines dashtype 3 linewidth 1.2 linecolor rgb '#495057' title 'BDF2, converged', \
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
