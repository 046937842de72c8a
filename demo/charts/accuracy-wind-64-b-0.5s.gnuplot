set encoding utf8
set logscale xy
set format '%g'
set border 3 linecolor rgb '#495057'
set tics nomirror
set grid xtics ytics mxtics mytics linetype 1 linewidth 1 linecolor rgb '#dde2e6', linetype 1 linewidth 0.5 linecolor rgb '#eff2f5'
set xrange [0.0574:262.45]
set yrange [0.0717759:918.109]
set title 'Hung sheet in wind, 64 × 64 particles: distance from the true motion (tiny steps) after 0.5 s' noenhanced font ',13'
set xlabel 'median time of a frame of 1/60 s [ms]'
set ylabel 'RMS distance of particles [mm]'
set key outside right top Left reverse samplen 2 spacing 1.25 font ',10' noenhanced
set rmargin 42
set bmargin 8
set label 1 'Intel(R) Xeon(R) Processor; 2 threads, 1 used; commit 12ab06f; κ = 2276; weft_study accuracy, then weft_study plot'."\n".'Not drawn, since they diverged: Explicit Euler substeps=126; Fibres and sets in substeps iterations=1 substeps=4; Fibres and sets iterations=1'."\n".' Jacobi (Kang): even iterations=2' at screen 0.012, screen 0.085 font ',8' textcolor rgb '#6c757d' noenhanced
$front << END
0.082 193.683 "iterations=1"
0.11 151.774 "iterations=3"
0.125 89.8555 "iterations=4"
0.175 79.7762 "iterations=8"
0.262 79.5099 "iterations=8"
0.269 67.7236 "iterations=16"
0.287 16.977 "passes=1"
0.436 16.7791 "passes=2"
0.555 10.4291 "passes=1 substeps=2"
1.153 6.94543 "passes=1 substeps=4"
2.319 4.77119 "passes=1 substeps=8"
4.801 3.11181 "passes=1 substeps=16"
5.905 0.228073 "substeps=126"
9.102 0.153919 "substeps=193"
18.274 0.102537 "substeps=386"
END
$curve0 << END
0.082 193.683 "iterations=1"
0.11 151.774 "iterations=3"
0.159 108.085 "iterations=7"
0.254 83.7029 "iterations=15"
0.435 79.9247 "iterations=31"
0.825 74.4886 "iterations=63"
1.584 64.6268 "iterations=127"
3.124 53.4037 "iterations=255"
END
$curve1 << END
0.171 114.53 "iterations=8"
0.269 98.7273 "iterations=16"
0.855 84.0144 "iterations=64"
END
$curve2 << END
0.122 193.921 "iterations=1"
0.193 95.3402 "iterations=7"
0.484 49.8905 "iterations=31"
1.57 39.8793 "iterations=127"
END
$curve3 << END
0.306 79.9707 "iterations=7 substeps=2"
0.606 64.0811 "iterations=7 substeps=4"
1.211 44.1124 "iterations=7 substeps=8"
2.393 23.2923 "iterations=7 substeps=16"
END
$curve4 << END
0.125 89.8555 "iterations=4"
0.175 79.7762 "iterations=8"
0.269 67.7236 "iterations=16"
0.469 42.8903 "iterations=32"
0.874 18.2849 "iterations=64"
1.641 19.094 "iterations=128"
END
$curve5 << END
0.166 94.9779 "iterations=4"
0.262 79.5099 "iterations=8"
0.462 59.2015 "iterations=16"
0.857 35.6038 "iterations=32"
1.658 18.986 "iterations=64"
3.254 18.7986 "iterations=128"
END
$curve6 << END
0.287 16.977 "passes=1"
0.436 16.7791 "passes=2"
0.581 16.3744 "passes=3"
0.736 16.386 "passes=4"
1.042 16.2682 "passes=6"
1.323 16.2259 "passes=8"
1.893 16.1844 "passes=12"
2.806 16.1609 "passes=18"
END
$curve7 << END
0.555 10.4291 "passes=1 substeps=2"
1.153 6.94543 "passes=1 substeps=4"
2.319 4.77119 "passes=1 substeps=8"
4.801 3.11181 "passes=1 substeps=16"
END
$curve8 << END
0.448 22.5947 "passes=2"
0.459 22.0781 "passes=1"
0.608 19.7769 "passes=3"
0.768 20.6963 "passes=4"
1.069 20.5027 "passes=6"
1.375 20.4404 "passes=8"
1.949 20.3352 "passes=12"
END
$curve9 << END
0.94 14.7319 "passes=1 substeps=2"
1.202 12.8045 "passes=3 substeps=2"
1.858 9.08163 "passes=1 substeps=4"
2.413 7.52097 "passes=3 substeps=4"
3.64 5.23028 "passes=1 substeps=8"
4.809 4.26685 "passes=3 substeps=8"
END
$curve10 << END
0.186 529.602 "substeps=1"
0.366 573.818 "substeps=2"
0.731 517.135 "substeps=4"
1.463 302.318 "substeps=8"
2.847 84.8554 "substeps=16"
5.682 35.4426 "substeps=32"
11.316 18.8998 "substeps=64"
END
$curve11 << END
0.298 498.809 "iterations=4"
0.745 407.307 "iterations=16"
2.551 207.688 "iterations=64"
END
$curve12 << END
0.326 475.172 "iterations=4"
0.867 346.091 "iterations=16"
3.003 136.669 "iterations=64"
END
$curve13 << END
2.949 66.8633 "iterations=1 substeps=16"
11.951 11.126 "iterations=1 substeps=64"
END
$curve14 << END
5.905 0.228073 "substeps=126"
9.102 0.153919 "substeps=193"
18.274 0.102537 "substeps=386"
END
$curve15 << END
22.301 1.36812 "substeps=386"
END
$curve16 << END
164.031 18.8671 "one factorisation a step"
END
$default << END
0.608 19.7769 "passes=3"
END
set terminal svg size 1200,760 font 'DejaVu Sans,13' background rgb 'white'
set output 'accuracy-wind-64-b-0.5s.svg'
plot $front using 1:2 with lines linewidth 9 linecolor rgb '#ffe8a3' title 'the front: nothing is cheaper and better', \
  16.1306 with lines dashtype 2 linewidth 1.2 linecolor rgb '#495057' title 'backward Euler, converged', \
  20.251 with lines dashtype 3 linewidth 1.2 linecolor rgb '#495057' title 'BDF2, converged', \
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
  $curve10 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 7 linecolor rgb '#9c36b5' title 'XPBD: substeps', \
  $curve11 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#da77f2' title 'XPBD: iterations', \
  $curve12 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 13 linecolor rgb '#e64980' title 'Fibres and sets', \
  $curve13 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 12 linecolor rgb '#f783ac' title 'Fibres and sets in substeps', \
  $curve14 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 15 linecolor rgb '#495057' title 'Symplectic Euler', \
  $curve15 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 14 linecolor rgb '#adb5bd' title 'Explicit Euler', \
  $curve16 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 2 linecolor rgb '#000000' title 'Sparse Cholesky', \
  $front using 1:2:3 with labels left offset 0.8,0.6 font ',7' textcolor rgb '#343a40' noenhanced notitle, \
  $default using 1:2 with points pointtype 3 pointsize 3 linewidth 3 linecolor rgb '#000000' title 'Weft''s default'
set terminal pngcairo size 1200,760 font 'DejaVu Sans,10' background rgb 'white'
set output 'accuracy-wind-64-b-0.5s.png'
plot $front using 1:2 with lines linewidth 9 linecolor rgb '#ffe8a3' title 'the front: nothing is cheaper and better', \
  16.1306 with lines dashtype 2 linewidth 1.2 linecolor rgb '#495057' title 'backward Euler, converged', \
  20.251 with lines dashtype 3 linewidth 1.2 linecolor rgb '#495057' title 'BDF2, converged', \
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
  $curve10 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 7 linecolor rgb '#9c36b5' title 'XPBD: substeps', \
  $curve11 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#da77f2' title 'XPBD: iterations', \
  $curve12 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 13 linecolor rgb '#e64980' title 'Fibres and sets', \
  $curve13 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 12 linecolor rgb '#f783ac' title 'Fibres and sets in substeps', \
  $curve14 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 15 linecolor rgb '#495057' title 'Symplectic Euler', \
  $curve15 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 14 linecolor rgb '#adb5bd' title 'Explicit Euler', \
  $curve16 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 2 linecolor rgb '#000000' title 'Sparse Cholesky', \
  $front using 1:2:3 with labels left offset 0.8,0.6 font ',7' textcolor rgb '#343a40' noenhanced notitle, \
  $default using 1:2 with points pointtype 3 pointsize 3 linewidth 3 linecolor rgb '#000000' title 'Weft''s default'
