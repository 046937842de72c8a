set encoding utf8
set logscale xy
set format '%g'
set border 3 linecolor rgb '#495057'
set tics nomirror
set grid xtics ytics mxtics mytics linetype 1 linewidth 1 linecolor rgb '#dde2e6', linetype 1 linewidth 0.5 linecolor rgb '#eff2f5'
set xrange [0.0155029:30.5173]
set yrange [1.05531:1888.61]
set title 'Sheet hung by two corners, 32 × 32 particles: distance from the method''s own converged step after 1 s' noenhanced font ',13'
set xlabel 'median time of a frame of 1/60 s [ms]'
set ylabel 'RMS distance of particles [mm]'
set key outside right top Left reverse samplen 2 spacing 1.25 font ',10' noenhanced
set rmargin 42
set bmargin 8
set label 1 'Intel(R) Xeon(R) Processor; 2 threads, 2 used; commit d3fa699+; κ = 569; weft_study accuracy, then weft_study plot'."\n".'Not drawn, since they diverged: Explicit Euler substeps=72; Jacobi (Kang): even iterations=2' at screen 0.012, screen 0.085 font ',8' textcolor rgb '#6c757d' noenhanced
$curve0 << END
0.022147 1180.38 "iterations=1"
0.028901 1078.75 "iterations=3"
0.042752 945.132 "iterations=7"
0.071287 768.353 "iterations=15"
0.127765 667.449 "iterations=31"
0.241328 554.35 "iterations=63"
0.461341 447.404 "iterations=127"
0.936175 341.414 "iterations=255"
END
$curve1 << END
0.046689 768.998 "iterations=8"
0.075001 619.426 "iterations=16"
0.241184 419.215 "iterations=64"
END
$curve2 << END
0.036462 824.252 "iterations=1"
0.057635 581.975 "iterations=7"
0.14062 422.078 "iterations=31"
0.474715 286.159 "iterations=127"
END
$curve3 << END
0.034989 803.478 "iterations=4"
0.049635 626.006 "iterations=8"
0.077241 356.554 "iterations=16"
0.134705 84.7388 "iterations=32"
0.249527 43.3796 "iterations=64"
0.493812 98.7579 "iterations=128"
END
$curve4 << END
0.042921 870.154 "iterations=4"
0.070987 641.343 "iterations=8"
0.128018 335.046 "iterations=16"
0.242139 156.239 "iterations=32"
0.471533 100.956 "iterations=64"
0.934494 103.109 "iterations=128"
END
$curve5 << END
0.079828 152.372 "iterations=1"
0.108225 35.0966 "iterations=2"
0.140357 13.3339 "iterations=3"
0.167163 10.2911 "iterations=4"
0.222973 18.5462 "iterations=6"
0.27449 6.77151 "iterations=8"
0.398857 7.94641 "iterations=12"
0.504583 4.25164 "iterations=16"
END
$curve6 << END
0.066324 152.233 "iterations=1"
0.087207 33.524 "iterations=2"
0.131943 28.9695 "iterations=4"
0.219243 29.6537 "iterations=8"
END
$curve7 << END
0.097394 19.8128 "passes=2 iterations=1"
0.118705 23.8087 "passes=2 iterations=2"
0.126108 13.7145 "passes=3 iterations=1"
0.149123 4.53657 "passes=3 iterations=2"
0.160958 4.39101 "passes=4 iterations=1"
0.162635 5.60072 "passes=2 iterations=4"
0.178854 2.17518 "passes=4 iterations=2"
0.191597 3.99393 "passes=3 iterations=4"
0.205648 6.86834 "passes=2 iterations=6"
0.218668 2.56223 "passes=6 iterations=1"
0.22426 1.9515 "passes=4 iterations=4"
0.236619 3.35259 "passes=3 iterations=6"
0.24122 2.09695 "passes=6 iterations=2"
0.280414 2.40119 "passes=8 iterations=1"
0.301969 1.50758 "passes=8 iterations=2"
END
$curve8 << END
0.09063 61.99 "passes=1 iterations=2"
0.12168 64.1681 "passes=2 iterations=2"
0.152 25.6147 "passes=3 iterations=2"
0.183338 18.338 "passes=4 iterations=2"
0.22531 13.3506 "passes=4 iterations=4"
0.2877 9.19035 "passes=6 iterations=4"
END
$curve9 << END
0.270343 45.6773 "passes=1 iterations=2"
0.377006 24.1886 "passes=2 iterations=2"
0.487787 12.6449 "passes=3 iterations=2"
0.604996 11.8205 "passes=4 iterations=2"
0.827837 8.55414 "passes=6 iterations=2"
END
$curve10 << END
19.0733 103.066 "one factorisation a step"
END
$default << END
0.149123 4.53657 "passes=3 iterations=2"
END
set terminal svg size 1200,760 font 'DejaVu Sans,13' background rgb 'white'
set output 'accuracy-hanging-32-own-1s.svg'
plot $curve0 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 7 linecolor rgb '#d62728' title 'Jacobi (Kang): odd', \
  $curve1 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#f4a6a6' title 'Jacobi (Kang): even', \
  $curve2 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 9 linecolor rgb '#8c1515' title 'Jacobi (Kang) with tethers', \
  $curve3 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 5 linecolor rgb '#f59f00' title 'Chebyshev', \
  $curve4 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 13 linecolor rgb '#b8860b' title 'Conjugate gradients', \
  $curve5 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 7 linecolor rgb '#1f77b4' title 'Multilevel: nonlinear CG', \
  $curve6 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#74c0fc' title 'Multilevel: one linear solve', \
  $curve7 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 5 linecolor rgb '#0b3d91' title 'Multilevel: Newton passes', \
  $curve8 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 9 linecolor rgb '#2b8a3e' title 'Multilevel: BDF2', \
  $curve9 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 4 linecolor rgb '#087f5b' title 'Multilevel: finite elements', \
  $curve10 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 2 linecolor rgb '#000000' title 'Sparse Cholesky', \
  $default using 1:2 with points pointtype 3 pointsize 3 linewidth 3 linecolor rgb '#000000' title 'Weft''s default'
set terminal pngcairo size 1200,760 font 'DejaVu Sans,10' background rgb 'white'
set output 'accuracy-hanging-32-own-1s.png'
plot $curve0 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 7 linecolor rgb '#d62728' title 'Jacobi (Kang): odd', \
  $curve1 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#f4a6a6' title 'Jacobi (Kang): even', \
  $curve2 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 9 linecolor rgb '#8c1515' title 'Jacobi (Kang) with tethers', \
  $curve3 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 5 linecolor rgb '#f59f00' title 'Chebyshev', \
  $curve4 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 13 linecolor rgb '#b8860b' title 'Conjugate gradients', \
  $curve5 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 7 linecolor rgb '#1f77b4' title 'Multilevel: nonlinear CG', \
  $curve6 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#74c0fc' title 'Multilevel: one linear solve', \
  $curve7 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 5 linecolor rgb '#0b3d91' title 'Multilevel: Newton passes', \
  $curve8 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 9 linecolor rgb '#2b8a3e' title 'Multilevel: BDF2', \
  $curve9 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 4 linecolor rgb '#087f5b' title 'Multilevel: finite elements', \
  $curve10 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 2 linecolor rgb '#000000' title 'Sparse Cholesky', \
  $default using 1:2 with points pointtype 3 pointsize 3 linewidth 3 linecolor rgb '#000000' title 'Weft''s default'
