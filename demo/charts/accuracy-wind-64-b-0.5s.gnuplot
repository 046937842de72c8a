set encoding utf8
set logscale xy
set format '%g'
set border 3 linecolor rgb '#495057'
set tics nomirror
set grid xtics ytics mxtics mytics linetype 1 linewidth 1 linecolor rgb '#dde2e6', linetype 1 linewidth 0.5 linecolor rgb '#eff2f5'
set xrange [0.07:271.626]
set yrange [0.0717759:918.109]
set title 'Hung sheet in wind, 64 × 64 particles: distance from the true motion (tiny steps) after 0.5 s' noenhanced font ',13'
set xlabel 'median time of a frame of 1/60 s [ms]'
set ylabel 'RMS distance of particles [mm]'
set key outside right top Left reverse samplen 2 spacing 1.25 font ',10' noenhanced
set rmargin 42
set bmargin 8
set label 1 'AMD EPYC; 2 threads, 1 used; commit 3697fc2; κ = 2276; weft_study accuracy, then weft_study plot'."\n".'Not drawn, since they diverged: Explicit Euler substeps=126; Fibres and sets in substeps iterations=1 substeps=4; Fibres and sets iterations=1'."\n".' Jacobi (Kang): even iterations=2' at screen 0.012, screen 0.085 font ',8' textcolor rgb '#6c757d' noenhanced
$front << END
0.1 193.683 "iterations=1"
0.125 151.774 "iterations=3"
0.139 89.8555 "iterations=4"
0.188 79.7762 "iterations=8"
0.232 19.2422 "iterations=1"
0.32 16.8439 "iterations=2"
0.443 16.1634 "passes=2 iterations=2"
0.454 12.536 "passes=1 substeps=2"
0.908 8.57962 "passes=1 substeps=4"
1.838 5.79821 "passes=1 substeps=8"
3.794 3.92948 "passes=1 substeps=16"
6.543 0.228073 "substeps=126"
10.039 0.153919 "substeps=193"
19.936 0.102537 "substeps=386"
END
$curve0 << END
0.1 193.683 "iterations=1"
0.125 151.774 "iterations=3"
0.172 108.085 "iterations=7"
0.265 83.7029 "iterations=15"
0.454 79.9247 "iterations=31"
0.836 74.4886 "iterations=63"
1.608 64.6268 "iterations=127"
3.16 53.4037 "iterations=255"
END
$curve1 << END
0.182 114.53 "iterations=8"
0.277 98.7273 "iterations=16"
0.845 84.0144 "iterations=64"
END
$curve2 << END
0.148 193.921 "iterations=1"
0.21 95.3402 "iterations=7"
0.49 49.8905 "iterations=31"
1.652 39.8793 "iterations=127"
END
$curve3 << END
0.33 79.9707 "iterations=7 substeps=2"
0.647 64.0811 "iterations=7 substeps=4"
1.294 44.1124 "iterations=7 substeps=8"
2.608 23.2923 "iterations=7 substeps=16"
END
$curve4 << END
0.139 89.8555 "iterations=4"
0.188 79.7762 "iterations=8"
0.287 67.7236 "iterations=16"
0.49 42.8903 "iterations=32"
0.91 18.2849 "iterations=64"
1.746 19.094 "iterations=128"
END
$curve5 << END
0.181 94.9769 "iterations=4"
0.284 79.5105 "iterations=8"
0.491 59.2024 "iterations=16"
0.916 35.6033 "iterations=32"
1.751 18.9859 "iterations=64"
3.441 18.7987 "iterations=128"
END
$curve6 << END
0.232 19.2422 "iterations=1"
0.32 16.8439 "iterations=2"
0.487 16.8314 "iterations=4"
0.804 16.9053 "iterations=8"
END
$curve7 << END
0.354 17.6635 "passes=2 iterations=1"
0.443 16.1634 "passes=2 iterations=2"
0.497 16.3505 "passes=3 iterations=1"
0.573 16.4083 "passes=3 iterations=2"
0.603 16.6449 "passes=4 iterations=1"
0.606 16.3922 "passes=2 iterations=4"
0.681 16.2875 "passes=4 iterations=2"
0.725 16.3445 "passes=3 iterations=4"
0.781 16.4135 "passes=2 iterations=6"
0.876 16.3041 "passes=4 iterations=4"
0.891 16.3997 "passes=6 iterations=1"
0.909 16.3167 "passes=3 iterations=6"
0.984 16.2619 "passes=6 iterations=2"
1.148 16.3053 "passes=8 iterations=1"
1.252 16.2387 "passes=8 iterations=2"
END
$curve8 << END
0.454 12.536 "passes=1 substeps=2"
0.908 8.57962 "passes=1 substeps=4"
1.838 5.79821 "passes=1 substeps=8"
3.794 3.92948 "passes=1 substeps=16"
END
$curve9 << END
0.453 19.5471 "passes=2 iterations=2"
0.483 22.0229 "passes=1 iterations=2"
0.582 20.6792 "passes=3 iterations=2"
0.718 20.2716 "passes=4 iterations=2"
0.878 20.4172 "passes=4 iterations=4"
1.166 20.4148 "passes=6 iterations=4"
END
$curve10 << END
1.167 13.7066 "passes=3 substeps=2"
2.377 8.15508 "passes=3 substeps=4"
4.998 4.60983 "passes=3 substeps=8"
END
$curve11 << END
0.216 529.602 "substeps=1"
0.42 573.818 "substeps=2"
0.828 517.135 "substeps=4"
1.667 302.318 "substeps=8"
3.376 84.8554 "substeps=16"
6.708 35.4426 "substeps=32"
13.442 18.8998 "substeps=64"
END
$curve12 << END
0.348 498.809 "iterations=4"
0.887 407.307 "iterations=16"
3.025 207.688 "iterations=64"
END
$curve13 << END
0.36 475.172 "iterations=4"
0.933 346.091 "iterations=16"
3.243 136.669 "iterations=64"
END
$curve14 << END
3.468 66.8633 "iterations=1 substeps=16"
13.723 11.126 "iterations=1 substeps=64"
END
$curve15 << END
6.543 0.228073 "substeps=126"
10.039 0.153919 "substeps=193"
19.936 0.102537 "substeps=386"
END
$curve16 << END
24.595 1.36812 "substeps=386"
END
$curve17 << END
169.766 18.8671 "one factorisation a step"
END
$default << END
0.582 20.6792 "passes=3 iterations=2"
END
set terminal svg size 1200,760 font 'DejaVu Sans,13' background rgb 'white'
set output 'accuracy-wind-64-b-0.5s.svg'
plot $front using 1:2 with lines linewidth 9 linecolor rgb '#ffe8a3' title 'the front: nothing is cheaper and better', \
  16.1306 with lines dashtype 2 linewidth 1.2 linecolor rgb '#495057' title 'backward Euler, converged', \
  20.2555 with lines dashtype 3 linewidth 1.2 linecolor rgb '#495057' title 'BDF2, converged', \
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
set output 'accuracy-wind-64-b-0.5s.png'
plot $front using 1:2 with lines linewidth 9 linecolor rgb '#ffe8a3' title 'the front: nothing is cheaper and better', \
  16.1306 with lines dashtype 2 linewidth 1.2 linecolor rgb '#495057' title 'backward Euler, converged', \
  20.2555 with lines dashtype 3 linewidth 1.2 linecolor rgb '#495057' title 'BDF2, converged', \
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
