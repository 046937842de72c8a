set encoding utf8
set logscale xy
set format '%g'
set border 3 linecolor rgb '#495057'
set tics nomirror
set grid xtics ytics mxtics mytics linetype 1 linewidth 1 linecolor rgb '#dde2e6', linetype 1 linewidth 0.5 linecolor rgb '#eff2f5'
set xrange [0.2471:412.272]
set yrange [0.0427617:1475.9]
set title 'Sheet hung by two corners, 128 × 128 particles: distance from the true motion (tiny steps) after 0.5 s' noenhanced font ',13'
set xlabel 'median time of a frame of 1/60 s [ms]'
set ylabel 'RMS distance of particles [mm]'
set key outside right top Left reverse samplen 2 spacing 1.25 font ',10' noenhanced
set rmargin 42
set bmargin 8
set label 1 'AMD EPYC; 2 threads, 1 used; commit 3697fc2; κ = 9102; weft_study accuracy, then weft_study plot'."\n".'Not drawn, since they diverged: Fibres and sets in substeps iterations=1 substeps=16; Fibres and sets in substeps iterations=1 substeps=4; Fibres and sets iterations=1'."\n".' Fibres and sets iterations=16; Fibres and sets iterations=4; Jacobi (Kang): even iterations=2' at screen 0.012, screen 0.085 font ',8' textcolor rgb '#6c757d' noenhanced
$front << END
0.353 830.794 "iterations=1"
0.47 824.01 "iterations=3"
0.534 798.651 "iterations=4"
0.754 762.638 "iterations=4"
0.765 735.454 "iterations=8"
1.245 704.105 "iterations=8"
1.263 645.963 "iterations=16"
1.366 47.407 "iterations=1"
2.303 35.3544 "iterations=2"
2.325 31.827 "passes=2 iterations=2"
2.709 23.7057 "passes=1 iterations=2"
2.73 16.6354 "passes=2 iterations=2"
6.349 8.95961 "passes=3 substeps=2"
12.421 5.09642 "passes=3 substeps=4"
24.122 2.55688 "passes=3 substeps=8"
58.971 0.0785398 "substeps=404"
107.458 0.0610882 "substeps=622"
END
$curve0 << END
0.353 830.794 "iterations=1"
0.47 824.01 "iterations=3"
0.684 810.976 "iterations=7"
1.168 787.188 "iterations=15"
2.153 749.01 "iterations=31"
4.108 701.47 "iterations=63"
7.307 653.854 "iterations=127"
14.242 597.229 "iterations=255"
END
$curve1 << END
0.743 816.234 "iterations=8"
1.248 795.166 "iterations=16"
4.124 705.588 "iterations=64"
END
$curve2 << END
0.555 830.742 "iterations=1"
0.877 810.44 "iterations=7"
2.305 742.738 "iterations=31"
7.929 583.918 "iterations=127"
END
$curve3 << END
1.378 751.492 "iterations=7 substeps=2"
2.78 661.573 "iterations=7 substeps=4"
5.391 527.388 "iterations=7 substeps=8"
10.686 346.303 "iterations=7 substeps=16"
END
$curve4 << END
0.534 798.651 "iterations=4"
0.765 735.454 "iterations=8"
1.263 645.963 "iterations=16"
2.263 519.11 "iterations=32"
4.177 428.972 "iterations=64"
8.111 220.616 "iterations=128"
END
$curve5 << END
0.754 762.638 "iterations=4"
1.245 704.105 "iterations=8"
2.211 623.751 "iterations=16"
4.101 501.983 "iterations=32"
7.712 338.032 "iterations=64"
14.943 120.238 "iterations=128"
END
$curve6 << END
1.366 47.407 "iterations=1"
2.303 35.3544 "iterations=2"
3.368 37.4976 "iterations=4"
4.949 36.7292 "iterations=8"
END
$curve7 << END
1.851 61.2502 "passes=2 iterations=1"
2.325 31.827 "passes=2 iterations=2"
2.406 35.8978 "passes=3 iterations=1"
2.973 37.2686 "passes=2 iterations=4"
3.017 36.5792 "passes=3 iterations=2"
3.293 43.6377 "passes=4 iterations=1"
3.67 35.1999 "passes=4 iterations=2"
3.711 36.8874 "passes=3 iterations=4"
3.961 36.7115 "passes=2 iterations=6"
4.449 39.0484 "passes=6 iterations=1"
4.503 36.3882 "passes=3 iterations=6"
4.702 36.3068 "passes=4 iterations=4"
5.063 35.6753 "passes=6 iterations=2"
5.672 37.4465 "passes=8 iterations=1"
6.166 35.7326 "passes=8 iterations=2"
END
$curve8 << END
3.244 28.099 "passes=1 substeps=2"
5.974 21.6347 "passes=1 substeps=4"
12.333 15.4753 "passes=1 substeps=8"
23.413 11.3661 "passes=1 substeps=16"
END
$curve9 << END
2.709 23.7057 "passes=1 iterations=2"
2.73 16.6354 "passes=2 iterations=2"
3.15 20.0771 "passes=3 iterations=2"
3.63 17.2958 "passes=4 iterations=2"
4.375 17.3774 "passes=4 iterations=4"
5.667 17.0475 "passes=6 iterations=4"
END
$curve10 << END
6.349 8.95961 "passes=3 substeps=2"
12.421 5.09642 "passes=3 substeps=4"
24.122 2.55688 "passes=3 substeps=8"
END
$curve11 << END
0.827 922.437 "substeps=1"
1.674 891.851 "substeps=2"
3.392 839.096 "substeps=4"
6.746 714.145 "substeps=8"
13.364 479.526 "substeps=16"
26.546 206.967 "substeps=32"
53.248 76.2751 "substeps=64"
END
$curve12 << END
1.465 902.228 "iterations=4"
3.835 845.103 "iterations=16"
12.654 692.912 "iterations=64"
END
$curve13 << END
13.033 608.972 "iterations=64"
END
$curve14 << END
56.584 34.9693 "iterations=1 substeps=64"
END
$curve15 << END
58.971 0.0785398 "substeps=404"
107.458 0.0610882 "substeps=622"
201.638 0.214685 "substeps=1243"
END
$curve16 << END
79.677 2.21181 "substeps=404"
257.67 0.323715 "substeps=1243"
END
$default << END
3.15 20.0771 "passes=3 iterations=2"
END
set terminal svg size 1200,760 font 'DejaVu Sans,13' background rgb 'white'
set output 'accuracy-hanging-128-b-0.5s.svg'
plot $front using 1:2 with lines linewidth 9 linecolor rgb '#ffe8a3' title 'the front: nothing is cheaper and better', \
  35.8766 with lines dashtype 2 linewidth 1.2 linecolor rgb '#495057' title 'backward Euler, converged', \
  17.0954 with lines dashtype 3 linewidth 1.2 linecolor rgb '#495057' title 'BDF2, converged', \
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
set output 'accuracy-hanging-128-b-0.5s.png'
plot $front using 1:2 with lines linewidth 9 linecolor rgb '#ffe8a3' title 'the front: nothing is cheaper and better', \
  35.8766 with lines dashtype 2 linewidth 1.2 linecolor rgb '#495057' title 'backward Euler, converged', \
  17.0954 with lines dashtype 3 linewidth 1.2 linecolor rgb '#495057' title 'BDF2, converged', \
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
