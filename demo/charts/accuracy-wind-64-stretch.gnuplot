set encoding utf8
set logscale xy
set format '%g'
set border 3 linecolor rgb '#495057'
set tics nomirror
set grid xtics ytics mxtics mytics linetype 1 linewidth 1 linecolor rgb '#dde2e6', linetype 1 linewidth 0.5 linecolor rgb '#eff2f5'
set xrange [0.0574:262.45]
set yrange [1.03709:8281.86]
set title 'Hung sheet in wind, 64 × 64 particles: worst stretch of a thread after 1 s' noenhanced font ',13'
set xlabel 'median time of a frame of 1/60 s [ms]'
set ylabel 'worst stretch [%]'
set key outside right top Left reverse samplen 2 spacing 1.25 font ',10' noenhanced
set rmargin 42
set bmargin 8
set label 1 'Intel(R) Xeon(R) Processor; 2 threads, 1 used; commit 12ab06f; κ = 2276; weft_study accuracy, then weft_study plot'."\n".'Not drawn, since they diverged: Explicit Euler substeps=126; Fibres and sets in substeps iterations=1 substeps=4; Fibres and sets iterations=1'."\n".' Jacobi (Kang): even iterations=2' at screen 0.012, screen 0.085 font ',8' textcolor rgb '#6c757d' noenhanced
$curve0 << END
0.082 107.791 "iterations=1"
0.11 158.415 "iterations=3"
0.159 184.265 "iterations=7"
0.254 182.928 "iterations=15"
0.435 120.879 "iterations=31"
0.825 64.7127 "iterations=63"
1.584 22.6632 "iterations=127"
3.124 18.5609 "iterations=255"
END
$curve1 << END
0.171 427.474 "iterations=8"
0.269 457.245 "iterations=16"
0.855 271.404 "iterations=64"
END
$curve2 << END
0.122 10.5205 "iterations=1"
0.193 2.11067 "iterations=7"
0.484 1.48156 "iterations=31"
1.57 1.68668 "iterations=127"
END
$curve3 << END
0.306 133.692 "iterations=7 substeps=2"
0.606 25.3395 "iterations=7 substeps=4"
1.211 34.9643 "iterations=7 substeps=8"
2.393 31.2025 "iterations=7 substeps=16"
END
$curve4 << END
0.125 196.032 "iterations=4"
0.175 106.817 "iterations=8"
0.269 22.5538 "iterations=16"
0.469 32.909 "iterations=32"
0.874 30.6669 "iterations=64"
1.641 29.5389 "iterations=128"
END
$curve5 << END
0.166 194.065 "iterations=4"
0.262 94.6394 "iterations=8"
0.462 21.2525 "iterations=16"
0.857 33.4826 "iterations=32"
1.658 30.2536 "iterations=64"
3.254 29.5688 "iterations=128"
END
$curve6 << END
0.287 30.4484 "passes=1"
0.436 30.0876 "passes=2"
0.581 30.004 "passes=3"
0.736 29.94 "passes=4"
1.042 29.9408 "passes=6"
1.323 30.0686 "passes=8"
1.893 29.9411 "passes=12"
2.806 29.8956 "passes=18"
END
$curve7 << END
0.555 31.1495 "passes=1 substeps=2"
1.153 30.3362 "passes=1 substeps=4"
2.319 29.5679 "passes=1 substeps=8"
4.801 29.1671 "passes=1 substeps=16"
END
$curve8 << END
0.448 28.2997 "passes=2"
0.459 28.1115 "passes=1"
0.608 29.7626 "passes=3"
0.768 29.5865 "passes=4"
1.069 28.4368 "passes=6"
1.375 28.4124 "passes=8"
1.949 28.5025 "passes=12"
END
$curve9 << END
0.94 29.5231 "passes=1 substeps=2"
1.202 30.6561 "passes=3 substeps=2"
1.858 30.6929 "passes=1 substeps=4"
2.413 31.6573 "passes=3 substeps=4"
3.64 32.8499 "passes=1 substeps=8"
4.809 31.8886 "passes=3 substeps=8"
END
$curve10 << END
1.02 38.6186 "passes=1"
1.618 33.3599 "passes=2"
2.186 33.3743 "passes=3"
2.797 32.9944 "passes=4"
3.873 32.8007 "passes=6"
END
$curve11 << END
0.186 4994.76 "substeps=1"
0.366 4130.49 "substeps=2"
0.731 2068.54 "substeps=4"
1.463 521.914 "substeps=8"
2.847 197.72 "substeps=16"
5.682 97.6799 "substeps=32"
11.316 57.969 "substeps=64"
END
$curve12 << END
0.298 3762.94 "iterations=4"
0.745 1676.93 "iterations=16"
2.551 365.133 "iterations=64"
END
$curve13 << END
0.326 5176.16 "iterations=4"
0.867 1502.44 "iterations=16"
3.003 381.038 "iterations=64"
END
$curve14 << END
2.949 158.131 "iterations=1 substeps=16"
11.951 46.0642 "iterations=1 substeps=64"
END
$curve15 << END
5.905 31.25 "substeps=126"
9.102 31.1939 "substeps=193"
18.274 31.2237 "substeps=386"
END
$curve16 << END
22.301 36.3608 "substeps=386"
END
$curve17 << END
164.031 29.572 "one factorisation a step"
END
$default << END
0.608 29.7626 "passes=3"
END
set terminal svg size 1200,760 font 'DejaVu Sans,13' background rgb 'white'
set output 'accuracy-wind-64-stretch.svg'
plot 31.2275 with lines dashtype 2 linewidth 1.2 linecolor rgb '#495057' title 'the true motion (tiny steps)', \
  $curve0 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 7 linecolor rgb '#d62728' title 'Jacobi (Kang): odd', \
  $curve1 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#f4a6a6' title 'Jacobi (Kang): even', \
  $curve2 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 9 linecolor rgb '#8c1515' title 'Jacobi (Kang) with tethers', \
  $curve3 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 8 linecolor rgb '#e8590c' title 'Jacobi (Kang) in substeps', \
  $curve4 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 5 linecolor rgb '#f59f00' title 'Chebyshev', \
  $curve5 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 13 linecolor rgb '#b8860b' title 'Conjugate gradients', \
  $curve6 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 5 linecolor rgb '#0b3d91' title 'Multilevel: Newton passes', \
  $curve7 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 8 linecolor rgb '#15aabf' title 'Multilevel in substeps', \
  $curve8 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 9 linecolor rgb '#2b8a3e' title 'Multilevel: BDF2', \
  $curve9 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 11 linecolor rgb '#74b816' title 'Multilevel: BDF2 in substeps', \
  $curve10 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 4 linecolor rgb '#087f5b' title 'Multilevel: finite elements', \
  $curve11 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 7 linecolor rgb '#9c36b5' title 'XPBD: substeps', \
  $curve12 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#da77f2' title 'XPBD: iterations', \
  $curve13 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 13 linecolor rgb '#e64980' title 'Fibres and sets', \
  $curve14 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 12 linecolor rgb '#f783ac' title 'Fibres and sets in substeps', \
  $curve15 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 15 linecolor rgb '#495057' title 'Symplectic Euler', \
  $curve16 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 14 linecolor rgb '#adb5bd' title 'Explicit Euler', \
  $curve17 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 2 linecolor rgb '#000000' title 'Sparse Cholesky', \
  $default using 1:2 with points pointtype 3 pointsize 3 linewidth 3 linecolor rgb '#000000' title 'Weft''s default'
set terminal pngcairo size 1200,760 font 'DejaVu Sans,10' background rgb 'white'
set output 'accuracy-wind-64-stretch.png'
plot 31.2275 with lines dashtype 2 linewidth 1.2 linecolor rgb '#495057' title 'the true motion (tiny steps)', \
  $curve0 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 7 linecolor rgb '#d62728' title 'Jacobi (Kang): odd', \
  $curve1 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#f4a6a6' title 'Jacobi (Kang): even', \
  $curve2 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 9 linecolor rgb '#8c1515' title 'Jacobi (Kang) with tethers', \
  $curve3 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 8 linecolor rgb '#e8590c' title 'Jacobi (Kang) in substeps', \
  $curve4 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 5 linecolor rgb '#f59f00' title 'Chebyshev', \
  $curve5 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 13 linecolor rgb '#b8860b' title 'Conjugate gradients', \
  $curve6 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 5 linecolor rgb '#0b3d91' title 'Multilevel: Newton passes', \
  $curve7 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 8 linecolor rgb '#15aabf' title 'Multilevel in substeps', \
  $curve8 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 9 linecolor rgb '#2b8a3e' title 'Multilevel: BDF2', \
  $curve9 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 11 linecolor rgb '#74b816' title 'Multilevel: BDF2 in substeps', \
  $curve10 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 4 linecolor rgb '#087f5b' title 'Multilevel: finite elements', \
  $curve11 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 7 linecolor rgb '#9c36b5' title 'XPBD: substeps', \
  $curve12 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#da77f2' title 'XPBD: iterations', \
  $curve13 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 13 linecolor rgb '#e64980' title 'Fibres and sets', \
  $curve14 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 12 linecolor rgb '#f783ac' title 'Fibres and sets in substeps', \
  $curve15 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 15 linecolor rgb '#495057' title 'Symplectic Euler', \
  $curve16 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 14 linecolor rgb '#adb5bd' title 'Explicit Euler', \
  $curve17 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 2 linecolor rgb '#000000' title 'Sparse Cholesky', \
  $default using 1:2 with points pointtype 3 pointsize 3 linewidth 3 linecolor rgb '#000000' title 'Weft''s default'
