set encoding utf8
set logscale xy
set format '%g'
set border 3 linecolor rgb '#495057'
set tics nomirror
set grid xtics ytics mxtics mytics linetype 1 linewidth 1 linecolor rgb '#dde2e6', linetype 1 linewidth 0.5 linecolor rgb '#eff2f5'
set xrange [0.0882504:327.646]
set yrange [7.89852:2749.04]
set title 'Hung sheet in wind, 64 × 64 particles: distance from converged backward Euler after 1 s' noenhanced font ',13'
set xlabel 'median time of a frame of 1/60 s [ms]'
set ylabel 'RMS distance of particles [mm]'
set key outside right top Left reverse samplen 2 spacing 1.25 font ',10' noenhanced
set rmargin 42
set bmargin 8
set label 1 'Intel(R) Xeon(R) Processor; 2 threads, 2 used; commit 05b8bef; κ = 2276; weft_study accuracy, then weft_study plot'."\n".'Not drawn, since they diverged: Fibres and sets iterations=1' at screen 0.012, screen 0.085 font ',8' textcolor rgb '#6c757d' noenhanced
$front << END
0.126072 125.469 "iterations=2"
0.252825 59.0373 "iterations=8"
0.322392 31.5114 "iterations=1"
0.384653 22.7831 "iterations=2"
0.400013 22.7754 "passes=1 iterations=2"
0.573597 22.317 "passes=3 iterations=1"
0.584969 21.3728 "iterations=3"
0.632787 19.4575 "iterations=4"
0.696086 15.6914 "passes=3 iterations=2"
1.35634 14.0301 "passes=6 iterations=2"
1.66978 11.2836 "passes=8 iterations=2"
END
$curve0 << END
0.144524 269.964 "iterations=1"
0.182098 295.56 "iterations=3"
0.272342 218.226 "iterations=7"
0.319835 130.509 "iterations=15"
0.564972 72.6051 "iterations=31"
0.927915 33.1026 "iterations=63"
1.75614 38.1885 "iterations=127"
3.35081 40.1605 "iterations=255"
END
$curve1 << END
0.126072 125.469 "iterations=2"
0.197894 272.691 "iterations=8"
0.300009 262.629 "iterations=16"
0.910649 53.6807 "iterations=64"
END
$curve2 << END
0.152808 146.004 "iterations=1"
0.216632 162.345 "iterations=7"
0.51648 92.1437 "iterations=31"
1.75347 37.0431 "iterations=127"
END
$curve3 << END
0.433444 88.1307 "iterations=7 substeps=2"
0.795507 33.5792 "iterations=7 substeps=4"
1.72956 25.936 "iterations=7 substeps=8"
3.20135 16.9885 "iterations=7 substeps=16"
END
$curve4 << END
0.179508 151.938 "iterations=4"
0.252825 59.0373 "iterations=8"
0.330129 38.762 "iterations=16"
0.525686 26.6673 "iterations=32"
1.17221 31.5117 "iterations=64"
1.96999 32.5905 "iterations=128"
END
$curve5 << END
0.20826 170.895 "iterations=4"
0.33934 50.5177 "iterations=8"
0.577442 42.1365 "iterations=16"
1.08252 27.8534 "iterations=32"
2.20435 33.5407 "iterations=64"
4.08268 32.7714 "iterations=128"
END
$curve6 << END
0.32264 31.5967 "iterations=1"
0.43527 29.5853 "iterations=2"
0.584969 21.3728 "iterations=3"
0.723517 19.2479 "iterations=4"
1.01554 16.0031 "iterations=6"
1.22843 18.1436 "iterations=8"
2.10526 15.8763 "iterations=12"
2.713 13.6117 "iterations=16"
END
$curve7 << END
0.322392 31.5114 "iterations=1"
0.384653 22.7831 "iterations=2"
0.632787 19.4575 "iterations=4"
1.15231 17.5586 "iterations=8"
END
$curve8 << END
0.469893 27.6393 "passes=2 iterations=1"
0.573597 22.317 "passes=3 iterations=1"
0.583669 22.5492 "passes=2 iterations=2"
0.696086 15.6914 "passes=3 iterations=2"
0.697873 21.2386 "passes=2 iterations=4"
0.817821 18.3952 "passes=4 iterations=1"
0.910451 19.6839 "passes=2 iterations=6"
0.952236 18.4019 "passes=4 iterations=2"
0.992976 19.2538 "passes=3 iterations=4"
1.00982 19.2725 "passes=6 iterations=1"
1.21429 18.4636 "passes=3 iterations=6"
1.29128 16.403 "passes=4 iterations=4"
1.35634 14.0301 "passes=6 iterations=2"
1.58673 16.5547 "passes=8 iterations=1"
1.66978 11.2836 "passes=8 iterations=2"
END
$curve9 << END
0.516482 24.3127 "passes=1 substeps=2"
1.03364 23.991 "passes=1 substeps=4"
2.0462 23.7938 "passes=1 substeps=8"
4.07905 27.2736 "passes=1 substeps=16"
END
$curve10 << END
0.400013 22.7754 "passes=1 iterations=2"
0.60241 23.1243 "passes=2 iterations=2"
0.753112 21.8886 "passes=3 iterations=2"
0.935222 23.0461 "passes=4 iterations=2"
1.08006 20.9136 "passes=4 iterations=4"
1.37462 18.6371 "passes=6 iterations=4"
END
$curve11 << END
1.491 20.2427 "passes=3 substeps=2"
2.88636 26.1099 "passes=3 substeps=4"
5.92314 27.6294 "passes=3 substeps=8"
END
$curve12 << END
0.142538 1718.15 "substeps=1"
0.244178 1293.74 "substeps=2"
0.49884 455.19 "substeps=4"
1.01407 170.383 "substeps=8"
2.005 76.2168 "substeps=16"
3.91791 43.2355 "substeps=32"
7.84685 27.4741 "substeps=64"
END
$curve13 << END
0.348506 1162.26 "iterations=4"
1.21967 329.247 "iterations=16"
4.60987 119.962 "iterations=64"
END
$curve14 << END
0.386099 913.794 "iterations=4"
1.38225 258.761 "iterations=16"
5.23283 126.688 "iterations=64"
END
$curve15 << END
0.556964 358.91 "iterations=1 substeps=4"
2.26575 74.6667 "iterations=1 substeps=16"
8.69652 26.5698 "iterations=1 substeps=64"
END
$curve16 << END
11.3821 28.0971 "substeps=213"
17.35 28.3229 "substeps=328"
34.2259 28.2505 "substeps=655"
END
$curve17 << END
15.2574 31.5157 "substeps=213"
46.9162 28.0665 "substeps=655"
END
$curve18 << END
204.779 32.7242 "one factorisation a step"
END
$default << END
0.696086 15.6914 "passes=3 iterations=2"
END
set terminal svg size 1200,760 font 'DejaVu Sans,13' background rgb 'white'
set output 'accuracy-wind-64-a-1s.svg'
plot $front using 1:2 with lines linewidth 9 linecolor rgb '#ffe8a3' title 'the front: nothing is cheaper and better', \
  32.7218 with lines dashtype 2 linewidth 1.2 linecolor rgb '#495057' title 'one linearisation, solved exactly', \
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
set output 'accuracy-wind-64-a-1s.png'
plot $front using 1:2 with lines linewidth 9 linecolor rgb '#ffe8a3' title 'the front: nothing is cheaper and better', \
  32.7218 with lines dashtype 2 linewidth 1.2 linecolor rgb '#495057' title 'one linearisation, solved exactly', \
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
