set encoding utf8
set logscale xy
set format '%g'
set border 3 linecolor rgb '#495057'
set tics nomirror
set grid xtics ytics mxtics mytics linetype 1 linewidth 1 linecolor rgb '#dde2e6', linetype 1 linewidth 0.5 linecolor rgb '#eff2f5'
set xrange [0.0602:270.744]
set yrange [1.27044:6499.14]
set title 'Sheet hung by two corners, 64 × 64 particles: distance from converged backward Euler after 1 s' noenhanced font ',13'
set xlabel 'median time of a frame of 1/60 s [ms]'
set ylabel 'RMS distance of particles [mm]'
set key outside right top Left reverse samplen 2 spacing 1.25 font ',10' noenhanced
set rmargin 42
set bmargin 8
set label 1 'AMD EPYC; 2 threads, 1 used; commit 3697fc2; κ = 2276; weft_study accuracy, then weft_study plot'."\n".'Not drawn, since they diverged: Explicit Euler substeps=126; Fibres and sets in substeps iterations=1 substeps=4; Fibres and sets iterations=1'."\n".' Fibres and sets iterations=4; Jacobi (Kang): even iterations=2' at screen 0.012, screen 0.085 font ',8' textcolor rgb '#6c757d' noenhanced
$front << END
0.086 1080.6 "iterations=1"
0.134 1022.18 "iterations=1"
0.169 972.962 "iterations=8"
0.176 936.053 "iterations=8"
0.202 873.231 "iterations=7"
0.257 117.022 "iterations=1"
0.349 24.2677 "passes=2 iterations=1"
0.431 9.04983 "passes=2 iterations=2"
0.473 9.03954 "iterations=2"
0.575 4.90734 "passes=3 iterations=2"
0.706 3.04059 "passes=4 iterations=2"
0.896 2.98566 "passes=4 iterations=4"
1.005 2.84932 "passes=6 iterations=2"
1.202 2.70583 "passes=8 iterations=1"
1.297 1.81492 "passes=8 iterations=2"
END
$curve0 << END
0.086 1080.6 "iterations=1"
0.109 1083.43 "iterations=3"
0.156 1090.43 "iterations=7"
0.251 1068.6 "iterations=15"
0.45 980.054 "iterations=31"
0.844 813.223 "iterations=63"
1.638 662.491 "iterations=127"
3.184 539.462 "iterations=255"
END
$curve1 << END
0.169 972.962 "iterations=8"
0.268 940.764 "iterations=16"
0.866 667.53 "iterations=64"
END
$curve2 << END
0.134 1022.18 "iterations=1"
0.202 873.231 "iterations=7"
0.505 577.821 "iterations=31"
1.714 403.312 "iterations=127"
END
$curve3 << END
0.305 985.64 "iterations=7 substeps=2"
0.597 495.494 "iterations=7 substeps=4"
1.192 123.743 "iterations=7 substeps=8"
2.422 115.081 "iterations=7 substeps=16"
END
$curve4 << END
0.125 1084.87 "iterations=4"
0.176 936.053 "iterations=8"
0.274 607.653 "iterations=16"
0.488 382.916 "iterations=32"
0.921 101.124 "iterations=64"
1.746 57.4665 "iterations=128"
END
$curve5 << END
0.169 1092.72 "iterations=4"
0.273 940.902 "iterations=8"
0.484 650.674 "iterations=16"
0.928 327.88 "iterations=32"
1.789 90.9001 "iterations=64"
3.495 99.3095 "iterations=128"
END
$curve6 << END
0.257 117.022 "iterations=1"
0.473 9.03954 "iterations=2"
0.679 7.977 "iterations=4"
0.995 8.44239 "iterations=8"
END
$curve7 << END
0.349 24.2677 "passes=2 iterations=1"
0.431 9.04983 "passes=2 iterations=2"
0.492 18.8453 "passes=3 iterations=1"
0.575 4.90734 "passes=3 iterations=2"
0.601 8.99808 "passes=2 iterations=4"
0.622 10.8876 "passes=4 iterations=1"
0.706 3.04059 "passes=4 iterations=2"
0.762 8.06785 "passes=2 iterations=6"
0.778 5.10171 "passes=3 iterations=4"
0.884 3.9017 "passes=6 iterations=1"
0.896 2.98566 "passes=4 iterations=4"
0.905 4.35719 "passes=3 iterations=6"
1.005 2.84932 "passes=6 iterations=2"
1.202 2.70583 "passes=8 iterations=1"
1.297 1.81492 "passes=8 iterations=2"
END
$curve8 << END
0.511 18.7606 "passes=1 substeps=2"
1.03 78.6454 "passes=1 substeps=4"
1.98 107.526 "passes=1 substeps=8"
4.324 122.023 "passes=1 substeps=16"
END
$curve9 << END
0.48 190.262 "passes=2 iterations=2"
0.49 167.618 "passes=1 iterations=2"
0.602 172.447 "passes=3 iterations=2"
0.725 169.535 "passes=4 iterations=2"
0.904 172.729 "passes=4 iterations=4"
1.183 174.542 "passes=6 iterations=4"
END
$curve10 << END
1.209 178.045 "passes=3 substeps=2"
2.435 180.813 "passes=3 substeps=4"
4.893 180.232 "passes=3 substeps=8"
END
$curve11 << END
0.202 4061.96 "substeps=1"
0.393 3186.84 "substeps=2"
0.777 1394.26 "substeps=4"
1.573 200.993 "substeps=8"
3.164 129.109 "substeps=16"
6.364 164.208 "substeps=32"
12.672 174.504 "substeps=64"
END
$curve12 << END
0.333 3144.84 "iterations=4"
0.881 1283.04 "iterations=16"
3.007 192.983 "iterations=64"
END
$curve13 << END
0.925 730.179 "iterations=16"
3.275 74.7914 "iterations=64"
END
$curve14 << END
3.306 178.032 "iterations=1 substeps=16"
12.957 176.206 "iterations=1 substeps=64"
END
$curve15 << END
4.486 179.451 "substeps=126"
6.734 179.424 "substeps=193"
13.467 179.099 "substeps=386"
END
$curve16 << END
18.884 182.525 "substeps=386"
END
$curve17 << END
169.215 86.8645 "one factorisation a step"
END
$default << END
0.602 172.447 "passes=3 iterations=2"
END
set terminal svg size 1200,760 font 'DejaVu Sans,13' background rgb 'white'
set output 'accuracy-hanging-64-a-1s.svg'
plot $front using 1:2 with lines linewidth 9 linecolor rgb '#ffe8a3' title 'the front: nothing is cheaper and better', \
  86.865 with lines dashtype 2 linewidth 1.2 linecolor rgb '#495057' title 'one linearisation, solved exactly', \
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
  $curve17 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 2 linecolor rgb '#000000' title 'Sparse Cholesky', \
  $front using 1:2:3 with labels left offset 0.8,0.6 font ',7' textcolor rgb '#343a40' noenhanced notitle, \
  $default using 1:2 with points pointtype 3 pointsize 3 linewidth 3 linecolor rgb '#000000' title 'Weft''s default'
set terminal pngcairo size 1200,760 font 'DejaVu Sans,10' background rgb 'white'
set output 'accuracy-hanging-64-a-1s.png'
plot $front using 1:2 with lines linewidth 9 linecolor rgb '#ffe8a3' title 'the front: nothing is cheaper and better', \
  86.865 with lines dashtype 2 linewidth 1.2 linecolor rgb '#495057' title 'one linearisation, solved exactly', \
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
  $curve17 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 2 linecolor rgb '#000000' title 'Sparse Cholesky', \
  $front using 1:2:3 with labels left offset 0.8,0.6 font ',7' textcolor rgb '#343a40' noenhanced notitle, \
  $default using 1:2 with points pointtype 3 pointsize 3 linewidth 3 linecolor rgb '#000000' title 'Weft''s default'
