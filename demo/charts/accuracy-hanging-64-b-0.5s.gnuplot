set encoding utf8
set logscale xy
set format '%g'
set border 3 linecolor rgb '#495057'
set tics nomirror
set grid xtics ytics mxtics mytics linetype 1 linewidth 1 linecolor rgb '#dde2e6', linetype 1 linewidth 0.5 linecolor rgb '#eff2f5'
set xrange [0.0602:270.744]
set yrange [0.189326:1446.05]
set title 'Sheet hung by two corners, 64 × 64 particles: distance from the true motion (tiny steps) after 0.5 s' noenhanced font ',13'
set xlabel 'median time of a frame of 1/60 s [ms]'
set ylabel 'RMS distance of particles [mm]'
set key outside right top Left reverse samplen 2 spacing 1.25 font ',10' noenhanced
set rmargin 42
set bmargin 8
set label 1 'AMD EPYC; 2 threads, 1 used; commit 3697fc2; κ = 2276; weft_study accuracy, then weft_study plot'."\n".'Not drawn, since they diverged: Explicit Euler substeps=126; Fibres and sets in substeps iterations=1 substeps=4; Fibres and sets iterations=1'."\n".' Fibres and sets iterations=4; Jacobi (Kang): even iterations=2' at screen 0.012, screen 0.085 font ',8' textcolor rgb '#6c757d' noenhanced
$front << END
0.086 760.784 "iterations=1"
0.109 724.245 "iterations=3"
0.125 657.383 "iterations=4"
0.176 566.106 "iterations=8"
0.257 49.0514 "iterations=1"
0.431 33.798 "passes=2 iterations=2"
0.48 16.8679 "passes=2 iterations=2"
1.209 9.93642 "passes=3 substeps=2"
2.435 4.07665 "passes=3 substeps=4"
4.486 0.298403 "substeps=126"
13.467 0.270466 "substeps=386"
END
$curve0 << END
0.086 760.784 "iterations=1"
0.109 724.245 "iterations=3"
0.156 683.594 "iterations=7"
0.251 644.915 "iterations=15"
0.45 597.825 "iterations=31"
0.844 579.978 "iterations=63"
1.638 538.755 "iterations=127"
3.184 473.781 "iterations=255"
END
$curve1 << END
0.169 669.333 "iterations=8"
0.268 618.545 "iterations=16"
0.866 530.173 "iterations=64"
END
$curve2 << END
0.134 756.144 "iterations=1"
0.202 637.269 "iterations=7"
0.505 458.079 "iterations=31"
1.714 379.729 "iterations=127"
END
$curve3 << END
0.305 610.681 "iterations=7 substeps=2"
0.597 498.416 "iterations=7 substeps=4"
1.192 338.356 "iterations=7 substeps=8"
2.422 212.747 "iterations=7 substeps=16"
END
$curve4 << END
0.125 657.383 "iterations=4"
0.176 566.106 "iterations=8"
0.274 552.955 "iterations=16"
0.488 410.616 "iterations=32"
0.921 166.382 "iterations=64"
1.746 70.4647 "iterations=128"
END
$curve5 << END
0.169 659.246 "iterations=4"
0.273 595.138 "iterations=8"
0.484 534.572 "iterations=16"
0.928 353.086 "iterations=32"
1.789 116.793 "iterations=64"
3.495 77.235 "iterations=128"
END
$curve6 << END
0.257 49.0514 "iterations=1"
0.473 36.8288 "iterations=2"
0.679 38.2577 "iterations=4"
0.995 37.9552 "iterations=8"
END
$curve7 << END
0.349 57.1516 "passes=2 iterations=1"
0.431 33.798 "passes=2 iterations=2"
0.492 35.342 "passes=3 iterations=1"
0.575 37.6968 "passes=3 iterations=2"
0.601 37.8802 "passes=2 iterations=4"
0.622 42.7207 "passes=4 iterations=1"
0.706 36.4099 "passes=4 iterations=2"
0.762 37.8357 "passes=2 iterations=6"
0.778 37.7381 "passes=3 iterations=4"
0.884 38.9475 "passes=6 iterations=1"
0.896 37.0486 "passes=4 iterations=4"
0.905 37.4824 "passes=3 iterations=6"
1.005 36.5641 "passes=6 iterations=2"
1.202 37.7447 "passes=8 iterations=1"
1.297 36.6972 "passes=8 iterations=2"
END
$curve8 << END
0.511 29.2481 "passes=1 substeps=2"
1.03 21.6542 "passes=1 substeps=4"
1.98 15.7619 "passes=1 substeps=8"
4.324 11.8596 "passes=1 substeps=16"
END
$curve9 << END
0.48 16.8679 "passes=2 iterations=2"
0.49 24.8746 "passes=1 iterations=2"
0.602 20.517 "passes=3 iterations=2"
0.725 18.6094 "passes=4 iterations=2"
0.904 19.0181 "passes=4 iterations=4"
1.183 18.5781 "passes=6 iterations=4"
END
$curve10 << END
1.209 9.93642 "passes=3 substeps=2"
2.435 4.07665 "passes=3 substeps=4"
4.893 1.76836 "passes=3 substeps=8"
END
$curve11 << END
0.202 903.782 "substeps=1"
0.393 836.433 "substeps=2"
0.777 689.671 "substeps=4"
1.573 425.918 "substeps=8"
3.164 160.526 "substeps=16"
6.364 62.1833 "substeps=32"
12.672 28.6824 "substeps=64"
END
$curve12 << END
0.333 839.479 "iterations=4"
0.881 672.822 "iterations=16"
3.007 375.88 "iterations=64"
END
$curve13 << END
0.925 592.186 "iterations=16"
3.275 272.912 "iterations=64"
END
$curve14 << END
3.306 94.8709 "iterations=1 substeps=16"
12.957 13.7412 "iterations=1 substeps=64"
END
$curve15 << END
4.486 0.298403 "substeps=126"
6.734 0.336283 "substeps=193"
13.467 0.270466 "substeps=386"
END
$curve16 << END
18.884 2.45771 "substeps=386"
END
$curve17 << END
169.215 75.5955 "one factorisation a step"
END
$default << END
0.602 20.517 "passes=3 iterations=2"
END
set terminal svg size 1200,760 font 'DejaVu Sans,13' background rgb 'white'
set output 'accuracy-hanging-64-b-0.5s.svg'
plot $front using 1:2 with lines linewidth 9 linecolor rgb '#ffe8a3' title 'the front: nothing is cheaper and better', \
  36.8286 with lines dashtype 2 linewidth 1.2 linecolor rgb '#495057' title 'backward Euler, converged', \
  18.7122 with lines dashtype 3 linewidth 1.2 linecolor rgb '#495057' title 'BDF2, converged', \
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
set output 'accuracy-hanging-64-b-0.5s.png'
plot $front using 1:2 with lines linewidth 9 linecolor rgb '#ffe8a3' title 'the front: nothing is cheaper and better', \
  36.8286 with lines dashtype 2 linewidth 1.2 linecolor rgb '#495057' title 'backward Euler, converged', \
  18.7122 with lines dashtype 3 linewidth 1.2 linecolor rgb '#495057' title 'BDF2, converged', \
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
