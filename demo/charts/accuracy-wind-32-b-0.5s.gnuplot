set encoding utf8
set logscale xy
set format '%g'
set border 3 linecolor rgb '#495057'
set tics nomirror
set grid xtics ytics mxtics mytics linetype 1 linewidth 1 linecolor rgb '#dde2e6', linetype 1 linewidth 0.5 linecolor rgb '#eff2f5'
set xrange [0.0273196:30.413]
set yrange [0.097587:740.203]
set title 'Hung sheet in wind, 32 × 32 particles: distance from the true motion (tiny steps) after 0.5 s' noenhanced font ',13'
set xlabel 'median time of a frame of 1/60 s [ms]'
set ylabel 'RMS distance of particles [mm]'
set key outside right top Left reverse samplen 2 spacing 1.25 font ',10' noenhanced
set rmargin 42
set bmargin 8
set label 1 'Intel(R) Xeon(R) Processor; 2 threads, 2 used; commit 05b8bef; κ = 569; weft_study accuracy, then weft_study plot'."\n".'Not drawn, since they diverged: Explicit Euler substeps=72' at screen 0.012, screen 0.085 font ',8' textcolor rgb '#6c757d' noenhanced
$front << END
0.039028 462.627 "substeps=1"
0.043802 93.3404 "iterations=1"
0.054254 85.3522 "iterations=3"
0.056787 62.1163 "iterations=1"
0.085598 45.9782 "iterations=7"
0.095057 18.0351 "iterations=1"
0.123677 16.178 "iterations=2"
0.159008 16.1664 "iterations=2"
0.178941 15.6159 "passes=2 iterations=2"
0.186456 10.8276 "passes=1 substeps=2"
0.368829 7.21166 "passes=1 substeps=4"
0.751062 4.4979 "passes=1 substeps=8"
1.49998 0.371891 "substeps=72"
2.34127 0.248793 "substeps=111"
4.6726 0.13941 "substeps=222"
END
$curve0 << END
0.043802 93.3404 "iterations=1"
0.054254 85.3522 "iterations=3"
0.074434 84.9948 "iterations=7"
0.114618 78.1087 "iterations=15"
0.195512 67.6562 "iterations=31"
0.356006 55.669 "iterations=63"
0.684149 41.6694 "iterations=127"
1.36156 28.3269 "iterations=255"
END
$curve1 << END
0.049196 226.45 "iterations=2"
0.081112 103.461 "iterations=8"
0.122337 72.1019 "iterations=16"
0.367667 55.3616 "iterations=64"
END
$curve2 << END
0.056787 62.1163 "iterations=1"
0.085598 45.9782 "iterations=7"
0.208385 35.5704 "iterations=31"
0.695601 36.2735 "iterations=127"
END
$curve3 << END
0.14475 65.633 "iterations=7 substeps=2"
0.286035 44.6608 "iterations=7 substeps=4"
0.570068 17.2514 "iterations=7 substeps=8"
1.16231 4.69676 "iterations=7 substeps=16"
END
$curve4 << END
0.060511 85.3093 "iterations=4"
0.080722 62.423 "iterations=8"
0.120911 38.4274 "iterations=16"
0.202228 19.7058 "iterations=32"
0.362939 19.3904 "iterations=64"
0.715716 18.8382 "iterations=128"
END
$curve5 << END
0.067974 87.9192 "iterations=4"
0.101188 57.8999 "iterations=8"
0.167673 33.4341 "iterations=16"
0.303052 18.815 "iterations=32"
0.593973 18.8256 "iterations=64"
1.13319 18.8564 "iterations=128"
END
$curve6 << END
0.118577 18.0359 "iterations=1"
0.159008 16.1664 "iterations=2"
0.200854 15.8651 "iterations=3"
0.236491 16.0908 "iterations=4"
0.32516 16.1008 "iterations=6"
0.404769 16.1058 "iterations=8"
0.603871 16.0717 "iterations=12"
0.762561 16.0633 "iterations=16"
END
$curve7 << END
0.095057 18.0351 "iterations=1"
0.123677 16.178 "iterations=2"
0.179687 16.4793 "iterations=4"
0.294167 16.5962 "iterations=8"
END
$curve8 << END
0.147515 16.9031 "passes=2 iterations=1"
0.178941 15.6159 "passes=2 iterations=2"
0.205224 15.6917 "passes=3 iterations=1"
0.226214 16.117 "passes=3 iterations=2"
0.23319 16.1668 "passes=2 iterations=4"
0.256645 16.3003 "passes=4 iterations=1"
0.298678 16.1858 "passes=2 iterations=6"
0.302245 16.013 "passes=4 iterations=2"
0.304462 16.1615 "passes=3 iterations=4"
0.369451 16.1186 "passes=3 iterations=6"
0.371022 16.1291 "passes=4 iterations=4"
0.376104 16.1648 "passes=6 iterations=1"
0.380325 16.0769 "passes=6 iterations=2"
0.490337 16.1172 "passes=8 iterations=1"
0.520572 16.0806 "passes=8 iterations=2"
END
$curve9 << END
0.186456 10.8276 "passes=1 substeps=2"
0.368829 7.21166 "passes=1 substeps=4"
0.751062 4.4979 "passes=1 substeps=8"
1.51004 2.9491 "passes=1 substeps=16"
END
$curve10 << END
0.129476 22.3795 "passes=1 iterations=2"
0.184801 19.6315 "passes=2 iterations=2"
0.243859 21.2377 "passes=3 iterations=2"
0.298077 20.8161 "passes=4 iterations=2"
0.337975 20.9753 "passes=4 iterations=4"
0.441596 20.9518 "passes=6 iterations=4"
END
$curve11 << END
0.485936 13.6176 "passes=3 substeps=2"
0.959499 7.9991 "passes=3 substeps=4"
1.92768 4.2989 "passes=3 substeps=8"
END
$curve12 << END
0.039028 462.627 "substeps=1"
0.065601 374.235 "substeps=2"
0.128956 167.726 "substeps=4"
0.25415 57.3721 "substeps=8"
0.518041 33.7597 "substeps=16"
1.02113 11.166 "substeps=32"
2.06538 3.96898 "substeps=64"
END
$curve13 << END
0.087206 311.378 "iterations=4"
0.297753 116.963 "iterations=16"
1.17688 42.2018 "iterations=64"
END
$curve14 << END
0.04415 442.891 "iterations=1"
0.106436 259.015 "iterations=4"
0.393953 85.7009 "iterations=16"
1.44432 40.3579 "iterations=64"
END
$curve15 << END
0.152125 130.407 "iterations=1 substeps=4"
0.59406 22.9439 "iterations=1 substeps=16"
2.39819 3.91437 "iterations=1 substeps=64"
END
$curve16 << END
1.49998 0.371891 "substeps=72"
2.34127 0.248793 "substeps=111"
4.6726 0.13941 "substeps=222"
END
$curve17 << END
5.16452 2.70751 "substeps=222"
END
$curve18 << END
19.0081 18.8553 "one factorisation a step"
END
$default << END
0.226214 16.117 "passes=3 iterations=2"
END
set terminal svg size 1200,760 font 'DejaVu Sans,13' background rgb 'white'
set output 'accuracy-wind-32-b-0.5s.svg'
plot $front using 1:2 with lines linewidth 9 linecolor rgb '#ffe8a3' title 'the front: nothing is cheaper and better', \
  16.0606 with lines dashtype 2 linewidth 1.2 linecolor rgb '#495057' title 'backward Euler, converged', \
  20.9341 with lines dashtype 3 linewidth 1.2 linecolor rgb '#495057' title 'BDF2, converged', \
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
set output 'accuracy-wind-32-b-0.5s.png'
plot $front using 1:2 with lines linewidth 9 linecolor rgb '#ffe8a3' title 'the front: nothing is cheaper and better', \
  16.0606 with lines dashtype 2 linewidth 1.2 linecolor rgb '#495057' title 'backward Euler, converged', \
  20.9341 with lines dashtype 3 linewidth 1.2 linecolor rgb '#495057' title 'BDF2, converged', \
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
