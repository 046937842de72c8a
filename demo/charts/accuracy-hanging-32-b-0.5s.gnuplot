set encoding utf8
set logscale xy
set format '%g'
set border 3 linecolor rgb '#495057'
set tics nomirror
set grid xtics ytics mxtics mytics linetype 1 linewidth 1 linecolor rgb '#dde2e6', linetype 1 linewidth 0.5 linecolor rgb '#eff2f5'
set xrange [0.0155029:30.5173]
set yrange [0.141491:1243.8]
set title 'Sheet hung by two corners, 32 × 32 particles: distance from the true motion (tiny steps) after 0.5 s' noenhanced font ',13'
set xlabel 'median time of a frame of 1/60 s [ms]'
set ylabel 'RMS distance of particles [mm]'
set key outside right top Left reverse samplen 2 spacing 1.25 font ',10' noenhanced
set rmargin 42
set bmargin 8
set label 1 'Intel(R) Xeon(R) Processor; 2 threads, 2 used; commit d3fa699+; κ = 569; weft_study accuracy, then weft_study plot'."\n".'Not drawn, since they diverged: Explicit Euler substeps=72; Jacobi (Kang): even iterations=2' at screen 0.012, screen 0.085 font ',8' textcolor rgb '#6c757d' noenhanced
$front << END
0.022147 612.831 "iterations=1"
0.034989 601.773 "iterations=4"
0.036462 570.25 "iterations=1"
0.046689 543.973 "iterations=8"
0.049635 534.349 "iterations=8"
0.057635 480.564 "iterations=7"
0.066324 64.9887 "iterations=1"
0.079828 64.987 "iterations=1"
0.087207 57.6061 "iterations=2"
0.09063 41.7114 "passes=1 iterations=2"
0.118705 40.5049 "passes=2 iterations=2"
0.12168 23.6458 "passes=2 iterations=2"
0.183338 20.4181 "passes=4 iterations=2"
0.301943 10.5498 "passes=3 substeps=2"
0.584773 0.346976 "substeps=72"
0.901584 0.286053 "substeps=111"
1.83529 0.20213 "substeps=222"
END
$curve0 << END
0.022147 612.831 "iterations=1"
0.028901 616.351 "iterations=3"
0.042752 620.963 "iterations=7"
0.071287 599.869 "iterations=15"
0.127765 554.143 "iterations=31"
0.241328 486.058 "iterations=63"
0.461341 402.715 "iterations=127"
0.936175 314.455 "iterations=255"
END
$curve1 << END
0.046689 543.973 "iterations=8"
0.075001 521.377 "iterations=16"
0.241184 463.914 "iterations=64"
END
$curve2 << END
0.036462 570.25 "iterations=1"
0.057635 480.564 "iterations=7"
0.14062 399.159 "iterations=31"
0.474715 295.78 "iterations=127"
END
$curve3 << END
0.082685 525.809 "iterations=7 substeps=2"
0.161123 354.458 "iterations=7 substeps=4"
0.317522 221.544 "iterations=7 substeps=8"
0.63727 89.7944 "iterations=7 substeps=16"
END
$curve4 << END
0.034989 601.773 "iterations=4"
0.049635 534.349 "iterations=8"
0.077241 377.919 "iterations=16"
0.134705 195.35 "iterations=32"
0.249527 86.8289 "iterations=64"
0.493812 86.1071 "iterations=128"
END
$curve5 << END
0.042921 616.624 "iterations=4"
0.070987 527.897 "iterations=8"
0.128018 355.447 "iterations=16"
0.242139 150.108 "iterations=32"
0.471533 89.5102 "iterations=64"
0.934494 88.5647 "iterations=128"
END
$curve6 << END
0.079828 64.987 "iterations=1"
0.108225 58.6472 "iterations=2"
0.140357 50.8937 "iterations=3"
0.167163 51.8166 "iterations=4"
0.222973 54.6743 "iterations=6"
0.27449 48.8901 "iterations=8"
0.398857 46.9551 "iterations=12"
0.504583 43.0913 "iterations=16"
END
$curve7 << END
0.066324 64.9887 "iterations=1"
0.087207 57.6061 "iterations=2"
0.131943 54.5823 "iterations=4"
0.219243 54.3874 "iterations=8"
END
$curve8 << END
0.097394 66.831 "passes=2 iterations=1"
0.118705 40.5049 "passes=2 iterations=2"
0.126108 40.8896 "passes=3 iterations=1"
0.149123 44.1927 "passes=3 iterations=2"
0.160958 50.1972 "passes=4 iterations=1"
0.162635 44.6702 "passes=2 iterations=4"
0.178854 41.5053 "passes=4 iterations=2"
0.191597 42.823 "passes=3 iterations=4"
0.205648 44.8453 "passes=2 iterations=6"
0.218668 45.1419 "passes=6 iterations=1"
0.22426 42.3311 "passes=4 iterations=4"
0.236619 42.5853 "passes=3 iterations=6"
0.24122 41.8766 "passes=6 iterations=2"
0.280414 43.4736 "passes=8 iterations=1"
0.301969 42.0867 "passes=8 iterations=2"
END
$curve9 << END
0.127283 39.1648 "passes=1 substeps=2"
0.251314 28.9598 "passes=1 substeps=4"
0.509747 19.2789 "passes=1 substeps=8"
1.03045 12.5696 "passes=1 substeps=16"
END
$curve10 << END
0.09063 41.7114 "passes=1 iterations=2"
0.12168 23.6458 "passes=2 iterations=2"
0.152 25.4596 "passes=3 iterations=2"
0.183338 20.4181 "passes=4 iterations=2"
0.22531 21.7768 "passes=4 iterations=4"
0.2877 21.3656 "passes=6 iterations=4"
END
$curve11 << END
0.301943 10.5498 "passes=3 substeps=2"
0.611668 4.32318 "passes=3 substeps=4"
1.21565 1.74843 "passes=3 substeps=8"
END
$curve12 << END
0.031173 777.377 "substeps=1"
0.052354 563.537 "substeps=2"
0.1018 298.505 "substeps=4"
0.192346 124.427 "substeps=8"
0.383305 64.7324 "substeps=16"
0.786081 27.7486 "substeps=32"
1.55263 9.99953 "substeps=64"
END
$curve13 << END
0.07918 540.845 "iterations=4"
0.284973 262.953 "iterations=16"
1.13067 116.886 "iterations=64"
END
$curve14 << END
0.034456 741.446 "iterations=1"
0.098605 473.497 "iterations=4"
0.359122 197.072 "iterations=16"
1.43423 73.662 "iterations=64"
END
$curve15 << END
0.12005 242.164 "iterations=1 substeps=4"
0.470019 29.0997 "iterations=1 substeps=16"
1.92365 5.10418 "iterations=1 substeps=64"
END
$curve16 << END
0.584773 0.346976 "substeps=72"
0.901584 0.286053 "substeps=111"
1.83529 0.20213 "substeps=222"
END
$curve17 << END
2.25661 3.17632 "substeps=222"
END
$curve18 << END
19.0733 88.5783 "one factorisation a step"
END
$default << END
0.149123 44.1927 "passes=3 iterations=2"
END
set terminal svg size 1200,760 font 'DejaVu Sans,13' background rgb 'white'
set output 'accuracy-hanging-32-b-0.5s.svg'
plot $front using 1:2 with lines linewidth 9 linecolor rgb '#ffe8a3' title 'the front: nothing is cheaper and better', \
  42.081 with lines dashtype 2 linewidth 1.2 linecolor rgb '#495057' title 'backward Euler, converged', \
  21.3079 with lines dashtype 3 linewidth 1.2 linecolor rgb '#495057' title 'BDF2, converged', \
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
set output 'accuracy-hanging-32-b-0.5s.png'
plot $front using 1:2 with lines linewidth 9 linecolor rgb '#ffe8a3' title 'the front: nothing is cheaper and better', \
  42.081 with lines dashtype 2 linewidth 1.2 linecolor rgb '#495057' title 'backward Euler, converged', \
  21.3079 with lines dashtype 3 linewidth 1.2 linecolor rgb '#495057' title 'BDF2, converged', \
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
