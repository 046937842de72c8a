set encoding utf8
set logscale xy
set format '%g'
set border 3 linecolor rgb '#495057'
set tics nomirror
set grid xtics ytics mxtics mytics linetype 1 linewidth 1 linecolor rgb '#dde2e6', linetype 1 linewidth 0.5 linecolor rgb '#eff2f5'
set xrange [0.0273196:30.413]
set yrange [0.81487:4205.58]
set title 'Hung sheet in wind, 32 × 32 particles: worst stretch of a thread after 1 s' noenhanced font ',13'
set xlabel 'median time of a frame of 1/60 s [ms]'
set ylabel 'worst stretch [%]'
set key outside right top Left reverse samplen 2 spacing 1.25 font ',10' noenhanced
set rmargin 42
set bmargin 8
set label 1 'Intel(R) Xeon(R) Processor; 2 threads, 2 used; commit 05b8bef; κ = 569; weft_study accuracy, then weft_study plot'."\n".'Not drawn, since they diverged: Explicit Euler substeps=72' at screen 0.012, screen 0.085 font ',8' textcolor rgb '#6c757d' noenhanced
$curve0 << END
0.043802 105.075 "iterations=1"
0.054254 62.4163 "iterations=3"
0.074434 34.8756 "iterations=7"
0.114618 11.6821 "iterations=15"
0.195512 4.03956 "iterations=31"
0.356006 4.7999 "iterations=63"
0.684149 10.8129 "iterations=127"
1.36156 7.5432 "iterations=255"
END
$curve1 << END
0.049196 2628.49 "iterations=2"
0.081112 176.433 "iterations=8"
0.122337 168.522 "iterations=16"
0.367667 5.04849 "iterations=64"
END
$curve2 << END
0.056787 37.5196 "iterations=1"
0.085598 6.9618 "iterations=7"
0.208385 1.2317 "iterations=31"
0.695601 1.1641 "iterations=127"
END
$curve3 << END
0.14475 4.32145 "iterations=7 substeps=2"
0.286035 13.1469 "iterations=7 substeps=4"
0.570068 9.2116 "iterations=7 substeps=8"
1.16231 8.50577 "iterations=7 substeps=16"
END
$curve4 << END
0.060511 21.9378 "iterations=4"
0.080722 4.1604 "iterations=8"
0.120911 10.2578 "iterations=16"
0.202228 8.37371 "iterations=32"
0.362939 8.3163 "iterations=64"
0.715716 8.35336 "iterations=128"
END
$curve5 << END
0.067974 22.1865 "iterations=4"
0.101188 4.52152 "iterations=8"
0.167673 8.90956 "iterations=16"
0.303052 8.4053 "iterations=32"
0.593973 8.32863 "iterations=64"
1.13319 8.33867 "iterations=128"
END
$curve6 << END
0.118577 8.42569 "iterations=1"
0.159008 8.55999 "iterations=2"
0.200854 8.51024 "iterations=3"
0.236491 8.5001 "iterations=4"
0.32516 8.46366 "iterations=6"
0.404769 8.4316 "iterations=8"
0.603871 8.438 "iterations=12"
0.762561 8.43776 "iterations=16"
END
$curve7 << END
0.095057 8.42638 "iterations=1"
0.123677 8.03137 "iterations=2"
0.179687 8.36456 "iterations=4"
0.294167 8.42988 "iterations=8"
END
$curve8 << END
0.147515 8.50631 "passes=2 iterations=1"
0.178941 8.45685 "passes=2 iterations=2"
0.205224 8.50696 "passes=3 iterations=1"
0.226214 8.43399 "passes=3 iterations=2"
0.23319 8.44037 "passes=2 iterations=4"
0.256645 8.48323 "passes=4 iterations=1"
0.298678 8.43539 "passes=2 iterations=6"
0.302245 8.42853 "passes=4 iterations=2"
0.304462 8.42461 "passes=3 iterations=4"
0.369451 8.44518 "passes=3 iterations=6"
0.371022 8.43571 "passes=4 iterations=4"
0.376104 8.46512 "passes=6 iterations=1"
0.380325 8.42752 "passes=6 iterations=2"
0.490337 8.45186 "passes=8 iterations=1"
0.520572 8.43231 "passes=8 iterations=2"
END
$curve9 << END
0.186456 8.74171 "passes=1 substeps=2"
0.368829 8.80034 "passes=1 substeps=4"
0.751062 8.58243 "passes=1 substeps=8"
1.51004 8.47109 "passes=1 substeps=16"
END
$curve10 << END
0.129476 8.03595 "passes=1 iterations=2"
0.184801 8.56901 "passes=2 iterations=2"
0.243859 8.26718 "passes=3 iterations=2"
0.298077 8.26647 "passes=4 iterations=2"
0.337975 8.25092 "passes=4 iterations=4"
0.441596 8.23626 "passes=6 iterations=4"
END
$curve11 << END
0.485936 8.66144 "passes=3 substeps=2"
0.959499 8.50589 "passes=3 substeps=4"
1.92768 8.39545 "passes=3 substeps=8"
END
$curve12 << END
0.039028 1909.11 "substeps=1"
0.065601 528.867 "substeps=2"
0.128956 211.244 "substeps=4"
0.25415 81.8518 "substeps=8"
0.518041 35.6562 "substeps=16"
1.02113 20.4746 "substeps=32"
2.06538 13.2134 "substeps=64"
END
$curve13 << END
0.087206 424.065 "iterations=4"
0.297753 144.49 "iterations=16"
1.17688 49.0148 "iterations=64"
END
$curve14 << END
0.04415 2249 "iterations=1"
0.106436 462.282 "iterations=4"
0.393953 104.554 "iterations=16"
1.44432 33.9654 "iterations=64"
END
$curve15 << END
0.152125 217.122 "iterations=1 substeps=4"
0.59406 27.4794 "iterations=1 substeps=16"
2.39819 8.78635 "iterations=1 substeps=64"
END
$curve16 << END
1.49998 8.29507 "substeps=72"
2.34127 8.30514 "substeps=111"
4.6726 8.31523 "substeps=222"
END
$curve17 << END
5.16452 8.46434 "substeps=222"
END
$curve18 << END
19.0081 8.33868 "one factorisation a step"
END
$curve19 << END
0.291578 16.1127 "passes=1 iterations=2"
0.420343 16.5139 "passes=2 iterations=2"
0.545494 16.6239 "passes=3 iterations=2"
0.660579 16.6643 "passes=4 iterations=2"
0.895616 16.5873 "passes=6 iterations=2"
END
$default << END
0.226214 8.43399 "passes=3 iterations=2"
END
set terminal svg size 1200,760 font 'DejaVu Sans,13' background rgb 'white'
set output 'accuracy-wind-32-stretch.svg'
plot 8.31996 with lines dashtype 2 linewidth 1.2 linecolor rgb '#495057' title 'the true motion (tiny steps)', \
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
set output 'accuracy-wind-32-stretch.png'
plot 8.31996 with lines dashtype 2 linewidth 1.2 linecolor rgb '#495057' title 'the true motion (tiny steps)', \
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
