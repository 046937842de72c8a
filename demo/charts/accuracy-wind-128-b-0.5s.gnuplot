set encoding utf8
set logscale xy
set format '%g'
set border 3 linecolor rgb '#495057'
set tics nomirror
set grid xtics ytics mxtics mytics linetype 1 linewidth 1 linecolor rgb '#dde2e6', linetype 1 linewidth 0.5 linecolor rgb '#eff2f5'
set xrange [0.2947:508.909]
set yrange [0.0334963:991.947]
set title 'Hung sheet in wind, 128 × 128 particles: distance from the true motion (tiny steps) after 0.5 s' noenhanced font ',13'
set xlabel 'median time of a frame of 1/60 s [ms]'
set ylabel 'RMS distance of particles [mm]'
set key outside right top Left reverse samplen 2 spacing 1.25 font ',10' noenhanced
set rmargin 42
set bmargin 8
set label 1 'AMD EPYC; 2 threads, 1 used; commit 3697fc2; κ = 9102; weft_study accuracy, then weft_study plot'."\n".'Not drawn, since they diverged: Fibres and sets in substeps iterations=1 substeps=4; Fibres and sets iterations=1; Fibres and sets iterations=4'."\n".' Jacobi (Kang): even iterations=2' at screen 0.012, screen 0.085 font ',8' textcolor rgb '#6c757d' noenhanced
$front << END
0.421 280.433 "iterations=1"
0.539 271.588 "iterations=3"
0.651 239.437 "iterations=4"
0.778 206.693 "iterations=4"
0.903 163.504 "iterations=8"
1.26 130.241 "iterations=8"
1.336 21.0285 "iterations=1"
1.53 17.494 "iterations=2"
2.314 16.3348 "passes=2 iterations=2"
3.276 13.5425 "passes=1 substeps=2"
6.935 10.3768 "passes=1 substeps=4"
12.691 7.9827 "passes=1 substeps=8"
20.686 5.5658 "passes=1 substeps=16"
29.653 4.87584 "passes=3 substeps=8"
89.578 0.0719057 "substeps=404"
139.069 0.0478519 "substeps=622"
END
$curve0 << END
0.421 280.433 "iterations=1"
0.539 271.588 "iterations=3"
0.818 254.951 "iterations=7"
1.36 225.698 "iterations=15"
2.301 180.744 "iterations=31"
4.299 126.793 "iterations=63"
8.301 88.9882 "iterations=127"
16.198 74.6255 "iterations=255"
END
$curve1 << END
0.857 284.477 "iterations=8"
1.376 302.845 "iterations=16"
4.453 157.55 "iterations=64"
END
$curve2 << END
0.636 280.434 "iterations=1"
0.982 255.213 "iterations=7"
2.485 183.151 "iterations=31"
8.394 82.5084 "iterations=127"
END
$curve3 << END
1.554 182.778 "iterations=7 substeps=2"
3.085 89.9803 "iterations=7 substeps=4"
6.357 64.9494 "iterations=7 substeps=8"
12.726 45.6241 "iterations=7 substeps=16"
END
$curve4 << END
0.651 239.437 "iterations=4"
0.903 163.504 "iterations=8"
1.386 82.4534 "iterations=16"
2.474 63.097 "iterations=32"
4.555 46.5478 "iterations=64"
8.701 22.7256 "iterations=128"
END
$curve5 << END
0.778 206.693 "iterations=4"
1.26 130.241 "iterations=8"
2.296 76.4012 "iterations=16"
4.204 63.1679 "iterations=32"
7.855 32.8791 "iterations=64"
15.152 19.1858 "iterations=128"
END
$curve6 << END
1.336 21.0285 "iterations=1"
1.53 17.494 "iterations=2"
2.342 16.9857 "iterations=4"
4.037 17.0904 "iterations=8"
END
$curve7 << END
1.759 18.4346 "passes=2 iterations=1"
2.314 16.3348 "passes=2 iterations=2"
2.679 16.5656 "passes=3 iterations=1"
2.901 16.5448 "passes=2 iterations=4"
3.095 16.524 "passes=3 iterations=2"
3.248 16.882 "passes=4 iterations=1"
3.951 16.4727 "passes=3 iterations=4"
4.003 16.3716 "passes=4 iterations=2"
4.025 16.5564 "passes=2 iterations=6"
4.803 16.4107 "passes=4 iterations=4"
4.944 16.4471 "passes=3 iterations=6"
5.057 16.3412 "passes=6 iterations=2"
5.08 16.5377 "passes=6 iterations=1"
6.149 16.4047 "passes=8 iterations=1"
6.338 16.3031 "passes=8 iterations=2"
END
$curve8 << END
3.276 13.5425 "passes=1 substeps=2"
6.935 10.3768 "passes=1 substeps=4"
12.691 7.9827 "passes=1 substeps=8"
20.686 5.5658 "passes=1 substeps=16"
END
$curve9 << END
2.658 22.2135 "passes=1 iterations=2"
3.163 19.1768 "passes=2 iterations=2"
3.832 20.1889 "passes=3 iterations=2"
4.157 19.994 "passes=4 iterations=2"
5.042 20.0096 "passes=4 iterations=4"
6.236 19.9007 "passes=6 iterations=4"
END
$curve10 << END
7.121 13.6584 "passes=3 substeps=2"
14.679 8.48736 "passes=3 substeps=4"
29.653 4.87584 "passes=3 substeps=8"
END
$curve11 << END
0.872 537.672 "substeps=1"
1.722 604.99 "substeps=2"
3.44 619.967 "substeps=4"
6.909 557.082 "substeps=8"
13.8 360.241 "substeps=16"
27.332 118.47 "substeps=32"
54.053 40.6414 "substeps=64"
END
$curve12 << END
1.434 528.748 "iterations=4"
3.742 501.869 "iterations=16"
12.404 420.378 "iterations=64"
END
$curve13 << END
3.702 480.237 "iterations=16"
12.553 362.574 "iterations=64"
END
$curve14 << END
13.751 259.763 "iterations=1 substeps=16"
54.642 35.5861 "iterations=1 substeps=64"
END
$curve15 << END
89.578 0.0719057 "substeps=404"
139.069 0.0478519 "substeps=622"
275.787 0.0546442 "substeps=1243"
END
$curve16 << END
104.272 1.43426 "substeps=404"
318.068 0.0750525 "substeps=1243"
END
$default << END
3.832 20.1889 "passes=3 iterations=2"
END
set terminal svg size 1200,760 font 'DejaVu Sans,13' background rgb 'white'
set output 'accuracy-wind-128-b-0.5s.svg'
plot $front using 1:2 with lines linewidth 9 linecolor rgb '#ffe8a3' title 'the front: nothing is cheaper and better', \
  16.1522 with lines dashtype 2 linewidth 1.2 linecolor rgb '#495057' title 'backward Euler, converged', \
  19.7913 with lines dashtype 3 linewidth 1.2 linecolor rgb '#495057' title 'BDF2, converged', \
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
set output 'accuracy-wind-128-b-0.5s.png'
plot $front using 1:2 with lines linewidth 9 linecolor rgb '#ffe8a3' title 'the front: nothing is cheaper and better', \
  16.1522 with lines dashtype 2 linewidth 1.2 linecolor rgb '#495057' title 'backward Euler, converged', \
  19.7913 with lines dashtype 3 linewidth 1.2 linecolor rgb '#495057' title 'BDF2, converged', \
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
