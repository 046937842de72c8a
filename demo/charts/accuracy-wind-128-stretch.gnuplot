set encoding utf8
set logscale xy
set format '%g'
set border 3 linecolor rgb '#495057'
set tics nomirror
set grid xtics ytics mxtics mytics linetype 1 linewidth 1 linecolor rgb '#dde2e6', linetype 1 linewidth 0.5 linecolor rgb '#eff2f5'
set xrange [0.284979:1010.47]
set yrange [3.08414:21561.3]
set title 'Hung sheet in wind, 128 × 128 particles: worst stretch of a thread after 1 s' noenhanced font ',13'
set xlabel 'median time of a frame of 1/60 s [ms]'
set ylabel 'worst stretch [%]'
set key outside right top Left reverse samplen 2 spacing 1.25 font ',10' noenhanced
set rmargin 42
set bmargin 8
set label 1 'Intel(R) Xeon(R) Processor; 2 threads, 2 used; commit 05b8bef; κ = 9102; weft_study accuracy, then weft_study plot'."\n".'Not drawn, since they diverged: Fibres and sets in substeps iterations=1 substeps=4; Fibres and sets iterations=1; Fibres and sets iterations=4' at screen 0.012, screen 0.085 font ',8' textcolor rgb '#6c757d' noenhanced
$curve0 << END
0.532151 355.669 "iterations=1"
0.624457 398.194 "iterations=3"
0.851288 441.379 "iterations=7"
1.11066 375.07 "iterations=15"
1.8616 346.659 "iterations=31"
3.34246 204.153 "iterations=63"
6.74611 126.387 "iterations=127"
12.6151 63.8601 "iterations=255"
END
$curve1 << END
0.502324 472.348 "iterations=2"
0.858906 536.718 "iterations=8"
1.34294 412.332 "iterations=16"
3.37405 206.313 "iterations=64"
END
$curve2 << END
0.607507 52.9064 "iterations=1"
0.960838 28.8611 "iterations=7"
2.01315 4.40591 "iterations=31"
7.33546 14.9537 "iterations=127"
END
$curve3 << END
1.43514 364.376 "iterations=7 substeps=2"
2.86863 156.874 "iterations=7 substeps=4"
5.64684 24.1782 "iterations=7 substeps=8"
11.4826 34.1795 "iterations=7 substeps=16"
END
$curve4 << END
0.71098 205.3 "iterations=4"
0.955551 198.45 "iterations=8"
1.20871 118.366 "iterations=16"
2.03349 21.5699 "iterations=32"
3.95041 33.171 "iterations=64"
7.72995 29.5752 "iterations=128"
END
$curve5 << END
0.717732 319.502 "iterations=4"
1.21127 265.009 "iterations=8"
1.98097 98.6293 "iterations=16"
3.51959 18.0098 "iterations=32"
8.0769 33.2611 "iterations=64"
13.5392 29.3136 "iterations=128"
END
$curve6 << END
1.59275 32.0883 "iterations=1"
2.47558 30.7348 "iterations=2"
2.69978 30.3704 "iterations=3"
3.51264 30.5206 "iterations=4"
5.24082 29.9251 "iterations=6"
6.55611 30.3345 "iterations=8"
8.80168 30.7103 "iterations=12"
9.76998 30.2121 "iterations=16"
END
$curve7 << END
1.33703 32.1746 "iterations=1"
1.81937 28.8016 "iterations=2"
2.04467 29.9163 "iterations=4"
3.3621 31.0103 "iterations=8"
END
$curve8 << END
2.05344 30.3946 "passes=2 iterations=1"
2.31201 30.3868 "passes=2 iterations=2"
2.43245 30.6085 "passes=3 iterations=1"
2.44172 30.2292 "passes=3 iterations=2"
3.08003 30.2609 "passes=4 iterations=1"
3.2871 30.6574 "passes=2 iterations=6"
3.51468 30.1948 "passes=2 iterations=4"
3.61496 30.6915 "passes=4 iterations=2"
3.67362 30.0219 "passes=6 iterations=1"
3.71596 31.0696 "passes=3 iterations=4"
4.33688 30.7171 "passes=3 iterations=6"
4.36094 31.3157 "passes=4 iterations=4"
4.58679 30.7649 "passes=6 iterations=2"
4.84819 30.697 "passes=8 iterations=1"
5.08992 30.2599 "passes=8 iterations=2"
END
$curve9 << END
2.15012 31.3841 "passes=1 substeps=2"
4.02831 30.0631 "passes=1 substeps=4"
8.97906 30.4512 "passes=1 substeps=8"
16.0231 29.6898 "passes=1 substeps=16"
END
$curve10 << END
1.69738 118.792 "passes=1 iterations=2"
2.2008 29.9242 "passes=2 iterations=2"
2.97054 29.4754 "passes=3 iterations=2"
3.25862 29.7059 "passes=4 iterations=2"
3.9926 29.7137 "passes=4 iterations=4"
5.46056 29.6905 "passes=6 iterations=4"
END
$curve11 << END
5.26816 30.4955 "passes=3 substeps=2"
10.7569 31.9237 "passes=3 substeps=4"
20.014 31.1742 "passes=3 substeps=8"
END
$curve12 << END
0.407113 13475.8 "substeps=1"
0.656025 12107.7 "substeps=2"
1.38434 8548.67 "substeps=4"
2.52321 3193.39 "substeps=8"
4.98351 893.641 "substeps=16"
9.7285 435.362 "substeps=32"
21.4179 204.818 "substeps=64"
END
$curve13 << END
0.864701 11066.2 "iterations=4"
2.92268 7205.81 "iterations=16"
14.1801 1982.33 "iterations=64"
END
$curve14 << END
4.01109 9599.37 "iterations=16"
15.3425 1581.18 "iterations=64"
END
$curve15 << END
6.50447 1005.04 "iterations=1 substeps=16"
27.953 154.642 "iterations=1 substeps=64"
END
$curve16 << END
3.53287 69.7221 "passes=1 iterations=2"
5.59302 65.0346 "passes=2 iterations=2"
6.57077 65.5652 "passes=3 iterations=2"
8.01861 65.153 "passes=4 iterations=2"
10.5091 65.3484 "passes=6 iterations=2"
END
$curve17 << END
145.911 30.4871 "substeps=740"
288.356 31.2183 "substeps=1138"
508.719 31.4421 "substeps=2276"
END
$curve18 << END
190.869 29.8804 "substeps=740"
631.541 31.7109 "substeps=2276"
END
$default << END
2.44172 30.2292 "passes=3 iterations=2"
END
set terminal svg size 1200,760 font 'DejaVu Sans,13' background rgb 'white'
set output 'accuracy-wind-128-stretch.svg'
plot 31.3843 with lines dashtype 2 linewidth 1.2 linecolor rgb '#495057' title 'the true motion (tiny steps)', \
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
  $curve16 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 4 linecolor rgb '#087f5b' title 'Multilevel: finite elements', \
  $curve17 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 15 linecolor rgb '#495057' title 'Symplectic Euler', \
  $curve18 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 14 linecolor rgb '#adb5bd' title 'Explicit Euler', \
  $default using 1:2 with points pointtype 3 pointsize 3 linewidth 3 linecolor rgb '#000000' title 'Weft''s default'
set terminal pngcairo size 1200,760 font 'DejaVu Sans,10' background rgb 'white'
set output 'accuracy-wind-128-stretch.png'
plot 31.3843 with lines dashtype 2 linewidth 1.2 linecolor rgb '#495057' title 'the true motion (tiny steps)', \
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
  $curve16 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 4 linecolor rgb '#087f5b' title 'Multilevel: finite elements', \
  $curve17 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 15 linecolor rgb '#495057' title 'Symplectic Euler', \
  $curve18 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 14 linecolor rgb '#adb5bd' title 'Explicit Euler', \
  $default using 1:2 with points pointtype 3 pointsize 3 linewidth 3 linecolor rgb '#000000' title 'Weft''s default'
