set encoding utf8
set logscale xy
set format '%g'
set border 3 linecolor rgb '#495057'
set tics nomirror
set grid xtics ytics mxtics mytics linetype 1 linewidth 1 linecolor rgb '#dde2e6', linetype 1 linewidth 0.5 linecolor rgb '#eff2f5'
set xrange [0.0226744:35.3981]
set yrange [1.06793:5875.79]
set title 'Sheet hung by two corners, 32 × 32 particles: worst stretch of a thread after 1 s' noenhanced font ',13'
set xlabel 'median time of a frame of 1/60 s [ms]'
set ylabel 'worst stretch [%]'
set key outside right top Left reverse samplen 2 spacing 1.25 font ',10' noenhanced
set rmargin 42
set bmargin 8
set label 1 'Intel(R) Xeon(R) Processor; 2 threads, 2 used; commit 05b8bef; κ = 569; weft_study accuracy, then weft_study plot'."\n".'Not drawn, since they diverged: Explicit Euler substeps=72; Jacobi (Kang): even iterations=2' at screen 0.012, screen 0.085 font ',8' textcolor rgb '#6c757d' noenhanced
$curve0 << END
0.053935 288.645 "iterations=1"
0.065594 191.52 "iterations=3"
0.068582 79.1372 "iterations=7"
0.148075 47.1819 "iterations=15"
0.255229 21.8748 "iterations=31"
0.476511 18.4109 "iterations=63"
0.748145 5.11182 "iterations=127"
1.61137 6.88128 "iterations=255"
END
$curve1 << END
0.087925 231.64 "iterations=8"
0.140337 202.75 "iterations=16"
0.437609 93.3481 "iterations=64"
END
$curve2 << END
0.058508 41.4728 "iterations=1"
0.09767 10.8535 "iterations=7"
0.279268 3.40822 "iterations=31"
0.814601 4.21718 "iterations=127"
END
$curve3 << END
0.134895 35.0752 "iterations=7 substeps=2"
0.257363 1.52561 "iterations=7 substeps=4"
0.508911 7.23111 "iterations=7 substeps=8"
1.04491 3.78849 "iterations=7 substeps=16"
END
$curve4 << END
0.054425 74.7775 "iterations=4"
0.074594 19.9151 "iterations=8"
0.114809 4.10332 "iterations=16"
0.200673 4.53679 "iterations=32"
0.357176 4.06944 "iterations=64"
0.705384 3.54592 "iterations=128"
END
$curve5 << END
0.061933 53.2662 "iterations=4"
0.094926 18.3134 "iterations=8"
0.160985 6.30488 "iterations=16"
0.293493 5.26741 "iterations=32"
0.627766 3.62429 "iterations=64"
1.1669 3.63561 "iterations=128"
END
$curve6 << END
0.113393 4.53567 "iterations=1"
0.191 3.928 "iterations=2"
0.211127 3.97846 "iterations=3"
0.2575 3.98684 "iterations=4"
0.319452 4.05658 "iterations=6"
0.417734 4.07268 "iterations=8"
0.626524 4.07704 "iterations=12"
0.737629 4.09142 "iterations=16"
END
$curve7 << END
0.088546 4.52359 "iterations=1"
0.115549 3.3534 "iterations=2"
0.176874 3.1954 "iterations=4"
0.310996 3.2698 "iterations=8"
END
$curve8 << END
0.139997 3.51813 "passes=2 iterations=1"
0.169782 4.2773 "passes=2 iterations=2"
0.189202 4.08684 "passes=3 iterations=1"
0.218908 4.20196 "passes=3 iterations=2"
0.264266 4.02199 "passes=2 iterations=4"
0.304475 4.0274 "passes=4 iterations=1"
0.318402 4.20022 "passes=4 iterations=2"
0.326172 4.09054 "passes=3 iterations=4"
0.387042 4.12517 "passes=4 iterations=4"
0.411197 4.01796 "passes=2 iterations=6"
0.414034 4.11388 "passes=3 iterations=6"
0.523151 4.12761 "passes=6 iterations=1"
0.526885 4.16144 "passes=8 iterations=2"
0.55128 4.16757 "passes=6 iterations=2"
0.676632 4.14312 "passes=8 iterations=1"
END
$curve9 << END
0.201197 4.2612 "passes=1 substeps=2"
0.441667 5.2622 "passes=1 substeps=4"
0.858253 4.21893 "passes=1 substeps=8"
1.44036 3.33635 "passes=1 substeps=16"
END
$curve10 << END
0.11896 2.10598 "passes=1 iterations=2"
0.171215 3.4307 "passes=2 iterations=2"
0.235335 2.64588 "passes=3 iterations=2"
0.30994 2.38659 "passes=4 iterations=2"
0.382104 2.04437 "passes=4 iterations=4"
0.491445 2.22115 "passes=6 iterations=4"
END
$curve11 << END
0.474829 3.08265 "passes=3 substeps=2"
0.938823 3.55478 "passes=3 substeps=4"
1.87742 4.81748 "passes=3 substeps=8"
END
$curve12 << END
0.032392 3672.37 "substeps=1"
0.054586 517.213 "substeps=2"
0.113706 109.625 "substeps=4"
0.268961 20.0979 "substeps=8"
0.622568 5.66738 "substeps=16"
1.2612 7.2713 "substeps=32"
2.52102 5.51264 "substeps=64"
END
$curve13 << END
0.134344 456.761 "iterations=4"
0.472377 86.6658 "iterations=16"
1.84227 22.5013 "iterations=64"
END
$curve14 << END
0.045374 3235.8 "iterations=1"
0.12685 331.103 "iterations=4"
0.446692 50.0134 "iterations=16"
1.76717 20.3088 "iterations=64"
END
$curve15 << END
0.163875 54.9635 "iterations=1 substeps=4"
0.632627 12.8254 "iterations=1 substeps=16"
2.53628 6.8582 "iterations=1 substeps=64"
END
$curve16 << END
1.31376 5.20399 "substeps=72"
2.02195 4.92747 "substeps=111"
3.00762 5.79849 "substeps=222"
END
$curve17 << END
3.46255 5.879 "substeps=222"
END
$curve18 << END
22.1238 3.63445 "one factorisation a step"
END
$curve19 << END
0.302026 8.64569 "passes=1 iterations=2"
0.50447 7.47997 "passes=2 iterations=2"
0.563861 7.89404 "passes=3 iterations=2"
0.66444 7.99391 "passes=4 iterations=2"
0.955679 8.05448 "passes=6 iterations=2"
END
$default << END
0.218908 4.20196 "passes=3 iterations=2"
END
set terminal svg size 1200,760 font 'DejaVu Sans,13' background rgb 'white'
set output 'accuracy-hanging-32-stretch.svg'
plot 5.35068 with lines dashtype 2 linewidth 1.2 linecolor rgb '#495057' title 'the true motion (tiny steps)', \
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
  $curve18 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 2 linecolor rgb '#000000' title 'Sparse Cholesky', \
  $curve19 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 4 linecolor rgb '#087f5b' title 'Multilevel: finite elements', \
  $default using 1:2 with points pointtype 3 pointsize 3 linewidth 3 linecolor rgb '#000000' title 'Weft''s default'
set terminal pngcairo size 1200,760 font 'DejaVu Sans,10' background rgb 'white'
set output 'accuracy-hanging-32-stretch.png'
plot 5.35068 with lines dashtype 2 linewidth 1.2 linecolor rgb '#495057' title 'the true motion (tiny steps)', \
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
  $curve18 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 2 linecolor rgb '#000000' title 'Sparse Cholesky', \
  $curve19 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 4 linecolor rgb '#087f5b' title 'Multilevel: finite elements', \
  $default using 1:2 with points pointtype 3 pointsize 3 linewidth 3 linecolor rgb '#000000' title 'Weft''s default'
