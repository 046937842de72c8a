set encoding utf8
set logscale xy
set format '%g'
set border 3 linecolor rgb '#495057'
set tics nomirror
set grid xtics ytics mxtics mytics linetype 1 linewidth 1 linecolor rgb '#dde2e6', linetype 1 linewidth 0.5 linecolor rgb '#eff2f5'
set xrange [0.0273196:30.413]
set yrange [0.172033:1703.14]
set title 'Hung sheet in wind, 32 × 32 particles: distance from converged backward Euler after 1 s' noenhanced font ',13'
set xlabel 'median time of a frame of 1/60 s [ms]'
set ylabel 'RMS distance of particles [mm]'
set key outside right top Left reverse samplen 2 spacing 1.25 font ',10' noenhanced
set rmargin 42
set bmargin 8
set label 1 'Intel(R) Xeon(R) Processor; 2 threads, 2 used; commit 05b8bef; κ = 569; weft_study accuracy, then weft_study plot'."\n".'Not drawn, since they diverged: Explicit Euler substeps=72' at screen 0.012, screen 0.085 font ',8' textcolor rgb '#6c757d' noenhanced
$front << END
0.039028 1064.46 "substeps=1"
0.043802 207.987 "iterations=1"
0.054254 124.102 "iterations=3"
0.060511 35.8803 "iterations=4"
0.067974 32.5544 "iterations=4"
0.095057 17.5116 "iterations=1"
0.118577 17.4999 "iterations=1"
0.147515 10.8029 "passes=2 iterations=1"
0.178941 3.0543 "passes=2 iterations=2"
0.226214 1.82178 "passes=3 iterations=2"
0.302245 0.773108 "passes=4 iterations=2"
0.380325 0.336307 "passes=6 iterations=2"
0.520572 0.245762 "passes=8 iterations=2"
END
$curve0 << END
0.043802 207.987 "iterations=1"
0.054254 124.102 "iterations=3"
0.074434 62.6157 "iterations=7"
0.114618 23.8808 "iterations=15"
0.195512 37.5234 "iterations=31"
0.356006 28.5832 "iterations=63"
0.684149 19.6103 "iterations=127"
1.36156 19.6884 "iterations=255"
END
$curve1 << END
0.049196 783.912 "iterations=2"
0.081112 344.504 "iterations=8"
0.122337 193.524 "iterations=16"
0.367667 28.7312 "iterations=64"
END
$curve2 << END
0.056787 160.564 "iterations=1"
0.085598 107.097 "iterations=7"
0.208385 40.5842 "iterations=31"
0.695601 38.5222 "iterations=127"
END
$curve3 << END
0.14475 41.8798 "iterations=7 substeps=2"
0.286035 20.252 "iterations=7 substeps=4"
0.570068 17.1046 "iterations=7 substeps=8"
1.16231 19.8633 "iterations=7 substeps=16"
END
$curve4 << END
0.060511 35.8803 "iterations=4"
0.080722 38.6259 "iterations=8"
0.120911 19.334 "iterations=16"
0.202228 21.4569 "iterations=32"
0.362939 19.9889 "iterations=64"
0.715716 20.1903 "iterations=128"
END
$curve5 << END
0.067974 32.5544 "iterations=4"
0.101188 37.281 "iterations=8"
0.167673 20.8535 "iterations=16"
0.303052 19.7161 "iterations=32"
0.593973 20.2488 "iterations=64"
1.13319 20.3929 "iterations=128"
END
$curve6 << END
0.118577 17.4999 "iterations=1"
0.159008 11.639 "iterations=2"
0.200854 3.45131 "iterations=3"
0.236491 3.68512 "iterations=4"
0.32516 3.26787 "iterations=6"
0.404769 1.38313 "iterations=8"
0.603871 0.766082 "iterations=12"
0.762561 0.429773 "iterations=16"
END
$curve7 << END
0.095057 17.5116 "iterations=1"
0.123677 28.4805 "iterations=2"
0.179687 12.6088 "iterations=4"
0.294167 11.8783 "iterations=8"
END
$curve8 << END
0.147515 10.8029 "passes=2 iterations=1"
0.178941 3.0543 "passes=2 iterations=2"
0.205224 4.03771 "passes=3 iterations=1"
0.226214 1.82178 "passes=3 iterations=2"
0.23319 2.60513 "passes=2 iterations=4"
0.256645 4.32469 "passes=4 iterations=1"
0.298678 2.52486 "passes=2 iterations=6"
0.302245 0.773108 "passes=4 iterations=2"
0.304462 1.8634 "passes=3 iterations=4"
0.369451 1.90489 "passes=3 iterations=6"
0.371022 0.784777 "passes=4 iterations=4"
0.376104 2.41594 "passes=6 iterations=1"
0.380325 0.336307 "passes=6 iterations=2"
0.490337 1.53039 "passes=8 iterations=1"
0.520572 0.245762 "passes=8 iterations=2"
END
$curve9 << END
0.186456 13.7311 "passes=1 substeps=2"
0.368829 15.2 "passes=1 substeps=4"
0.751062 22.3374 "passes=1 substeps=8"
1.51004 23.0883 "passes=1 substeps=16"
END
$curve10 << END
0.129476 17.574 "passes=1 iterations=2"
0.184801 8.64009 "passes=2 iterations=2"
0.243859 8.19537 "passes=3 iterations=2"
0.298077 8.89949 "passes=4 iterations=2"
0.337975 9.0479 "passes=4 iterations=4"
0.441596 9.19438 "passes=6 iterations=4"
END
$curve11 << END
0.485936 14.8644 "passes=3 substeps=2"
0.959499 21.7609 "passes=3 substeps=4"
1.92768 22.5693 "passes=3 substeps=8"
END
$curve12 << END
0.039028 1064.46 "substeps=1"
0.065601 325.246 "substeps=2"
0.128956 147.711 "substeps=4"
0.25415 64.2097 "substeps=8"
0.518041 30.0946 "substeps=16"
1.02113 18.6496 "substeps=32"
2.06538 22.8993 "substeps=64"
END
$curve13 << END
0.087206 267.177 "iterations=4"
0.297753 106.323 "iterations=16"
1.17688 46.1503 "iterations=64"
END
$curve14 << END
0.04415 857.563 "iterations=1"
0.106436 240.961 "iterations=4"
0.393953 108.465 "iterations=16"
1.44432 39.8925 "iterations=64"
END
$curve15 << END
0.152125 152.984 "iterations=1 substeps=4"
0.59406 31.404 "iterations=1 substeps=16"
2.39819 24.2135 "iterations=1 substeps=64"
END
$curve16 << END
1.49998 22.5243 "substeps=72"
2.34127 22.5571 "substeps=111"
4.6726 22.5513 "substeps=222"
END
$curve17 << END
5.16452 23.4746 "substeps=222"
END
$curve18 << END
19.0081 20.395 "one factorisation a step"
END
$default << END
0.226214 1.82178 "passes=3 iterations=2"
END
set terminal svg size 1200,760 font 'DejaVu Sans,13' background rgb 'white'
set output 'accuracy-wind-32-a-1s.svg'
plot $front using 1:2 with lines linewidth 9 linecolor rgb '#ffe8a3' title 'the front: nothing is cheaper and better', \
  20.395 with lines dashtype 2 linewidth 1.2 linecolor rgb '#495057' title 'one linearisation, solved exactly', \
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
  $front using 1:2:3 with labels left offset 0.8,0.6 font ',7' textcolor rgb '#343a40' noenhanced notitle, \
  $default using 1:2 with points pointtype 3 pointsize 3 linewidth 3 linecolor rgb '#000000' title 'Weft''s default'
set terminal pngcairo size 1200,760 font 'DejaVu Sans,10' background rgb 'white'
set output 'accuracy-wind-32-a-1s.png'
plot $front using 1:2 with lines linewidth 9 linecolor rgb '#ffe8a3' title 'the front: nothing is cheaper and better', \
  20.395 with lines dashtype 2 linewidth 1.2 linecolor rgb '#495057' title 'one linearisation, solved exactly', \
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
  $front using 1:2:3 with labels left offset 0.8,0.6 font ',7' textcolor rgb '#343a40' noenhanced notitle, \
  $default using 1:2 with points pointtype 3 pointsize 3 linewidth 3 linecolor rgb '#000000' title 'Weft''s default'
