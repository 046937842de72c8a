set encoding utf8
set logscale xy
set format '%g'
set border 3 linecolor rgb '#495057'
set tics nomirror
set grid xtics ytics mxtics mytics linetype 1 linewidth 1 linecolor rgb '#dde2e6', linetype 1 linewidth 0.5 linecolor rgb '#eff2f5'
set xrange [0.0882504:327.646]
set yrange [0.517757:873.275]
set title 'Hung sheet in wind, 64 × 64 particles: distance from the true motion (tiny steps) after 0.5 s' noenhanced font ',13'
set xlabel 'median time of a frame of 1/60 s [ms]'
set ylabel 'RMS distance of particles [mm]'
set key outside right top Left reverse samplen 2 spacing 1.25 font ',10' noenhanced
set rmargin 42
set bmargin 8
set label 1 'Intel(R) Xeon(R) Processor; 2 threads, 2 used; commit 05b8bef; κ = 2276; weft_study accuracy, then weft_study plot'."\n".'Not drawn, since they diverged: Fibres and sets iterations=1' at screen 0.012, screen 0.085 font ',8' textcolor rgb '#6c757d' noenhanced
$front << END
0.126072 121.656 "iterations=2"
0.152808 98.6436 "iterations=1"
0.179508 89.3791 "iterations=4"
0.216632 60.9283 "iterations=7"
0.322392 20.5107 "iterations=1"
0.384653 18.0798 "iterations=2"
0.516482 15.1501 "passes=1 substeps=2"
1.03364 11.4542 "passes=1 substeps=4"
2.0462 10.1015 "passes=1 substeps=8"
2.88636 8.48474 "passes=3 substeps=4"
4.07905 5.72958 "passes=1 substeps=16"
5.92314 4.83363 "passes=3 substeps=8"
11.3821 0.810023 "substeps=213"
34.2259 0.739653 "substeps=655"
END
$curve0 << END
0.144524 127.803 "iterations=1"
0.182098 123.219 "iterations=3"
0.272342 97.0102 "iterations=7"
0.319835 86.2852 "iterations=15"
0.564972 86.0741 "iterations=31"
0.927915 79.2384 "iterations=63"
1.75614 68.703 "iterations=127"
3.35081 57.3968 "iterations=255"
END
$curve1 << END
0.126072 121.656 "iterations=2"
0.197894 102.179 "iterations=8"
0.300009 98.4032 "iterations=16"
0.910649 78.1119 "iterations=64"
END
$curve2 << END
0.152808 98.6436 "iterations=1"
0.216632 60.9283 "iterations=7"
0.51648 48.2234 "iterations=31"
1.75347 37.8005 "iterations=127"
END
$curve3 << END
0.433444 84.37 "iterations=7 substeps=2"
0.795507 66.7377 "iterations=7 substeps=4"
1.72956 47.6047 "iterations=7 substeps=8"
3.20135 23.86 "iterations=7 substeps=16"
END
$curve4 << END
0.179508 89.3791 "iterations=4"
0.252825 86.9256 "iterations=8"
0.330129 65.2335 "iterations=16"
0.525686 42.7876 "iterations=32"
1.17221 23.3945 "iterations=64"
1.96999 22.0361 "iterations=128"
END
$curve5 << END
0.20826 91.5717 "iterations=4"
0.33934 87.3895 "iterations=8"
0.577442 60.6189 "iterations=16"
1.08252 37.0873 "iterations=32"
2.20435 21.8712 "iterations=64"
4.08268 21.7558 "iterations=128"
END
$curve6 << END
0.32264 20.5236 "iterations=1"
0.43527 19.2011 "iterations=2"
0.584969 18.2943 "iterations=3"
0.723517 18.3861 "iterations=4"
1.01554 18.1413 "iterations=6"
1.22843 18.2396 "iterations=8"
2.10526 18.3925 "iterations=12"
2.713 18.4549 "iterations=16"
END
$curve7 << END
0.322392 20.5107 "iterations=1"
0.384653 18.0798 "iterations=2"
0.632787 17.4013 "iterations=4"
1.15231 17.561 "iterations=8"
END
$curve8 << END
0.469893 20.0552 "passes=2 iterations=1"
0.573597 18.1196 "passes=3 iterations=1"
0.583669 18.0439 "passes=2 iterations=2"
0.696086 18.2469 "passes=3 iterations=2"
0.697873 18.4672 "passes=2 iterations=4"
0.817821 18.6728 "passes=4 iterations=1"
0.910451 18.4899 "passes=2 iterations=6"
0.952236 18.2594 "passes=4 iterations=2"
0.992976 18.3127 "passes=3 iterations=4"
1.00982 18.485 "passes=6 iterations=1"
1.21429 18.2487 "passes=3 iterations=6"
1.29128 18.3718 "passes=4 iterations=4"
1.35634 18.353 "passes=6 iterations=2"
1.58673 18.5031 "passes=8 iterations=1"
1.66978 18.3813 "passes=8 iterations=2"
END
$curve9 << END
0.516482 15.1501 "passes=1 substeps=2"
1.03364 11.4542 "passes=1 substeps=4"
2.0462 10.1015 "passes=1 substeps=8"
4.07905 5.72958 "passes=1 substeps=16"
END
$curve10 << END
0.400013 23.8921 "passes=1 iterations=2"
0.60241 20.8222 "passes=2 iterations=2"
0.753112 22.4873 "passes=3 iterations=2"
0.935222 21.7853 "passes=4 iterations=2"
1.08006 22.0833 "passes=4 iterations=4"
1.37462 22.1084 "passes=6 iterations=4"
END
$curve11 << END
1.491 14.6842 "passes=3 substeps=2"
2.88636 8.48474 "passes=3 substeps=4"
5.92314 4.83363 "passes=3 substeps=8"
END
$curve12 << END
0.142538 524.698 "substeps=1"
0.244178 545.797 "substeps=2"
0.49884 439.962 "substeps=4"
1.01407 218.23 "substeps=8"
2.005 70.2588 "substeps=16"
3.91791 40.3185 "substeps=32"
7.84685 19.1355 "substeps=64"
END
$curve13 << END
0.348506 472.472 "iterations=4"
1.21967 335.351 "iterations=16"
4.60987 139.213 "iterations=64"
END
$curve14 << END
0.386099 445.407 "iterations=4"
1.38225 277.17 "iterations=16"
5.23283 101.486 "iterations=64"
END
$curve15 << END
0.556964 387.914 "iterations=1 substeps=4"
2.26575 63.3355 "iterations=1 substeps=16"
8.69652 13.7771 "iterations=1 substeps=64"
END
$curve16 << END
11.3821 0.810023 "substeps=213"
17.35 0.821832 "substeps=328"
34.2259 0.739653 "substeps=655"
END
$curve17 << END
15.2574 9.37849 "substeps=213"
46.9162 2.05026 "substeps=655"
END
$curve18 << END
204.779 21.8118 "one factorisation a step"
END
$default << END
0.696086 18.2469 "passes=3 iterations=2"
END
set terminal svg size 1200,760 font 'DejaVu Sans,13' background rgb 'white'
set output 'accuracy-wind-64-b-0.5s.svg'
plot $front using 1:2 with lines linewidth 9 linecolor rgb '#ffe8a3' title 'the front: nothing is cheaper and better', \
  18.2997 with lines dashtype 2 linewidth 1.2 linecolor rgb '#495057' title 'backward Euler, converged', \
  22.0121 with lines dashtype 3 linewidth 1.2 linecolor rgb '#495057' title 'BDF2, converged', \
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
set output 'accuracy-wind-64-b-0.5s.png'
plot $front using 1:2 with lines linewidth 9 linecolor rgb '#ffe8a3' title 'the front: nothing is cheaper and better', \
  18.2997 with lines dashtype 2 linewidth 1.2 linecolor rgb '#495057' title 'backward Euler, converged', \
  22.0121 with lines dashtype 3 linewidth 1.2 linecolor rgb '#495057' title 'BDF2, converged', \
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
