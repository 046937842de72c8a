set encoding utf8
set logscale xy
set format '%g'
set border 3 linecolor rgb '#495057'
set tics nomirror
set grid xtics ytics mxtics mytics linetype 1 linewidth 1 linecolor rgb '#dde2e6', linetype 1 linewidth 0.5 linecolor rgb '#eff2f5'
set xrange [0.0483:242.042]
set yrange [0.189326:1446.05]
set title 'Sheet hung by two corners, 64 × 64 particles: distance from the true motion (tiny steps) after 0.5 s' noenhanced font ',13'
set xlabel 'median time of a frame of 1/60 s [ms]'
set ylabel 'RMS distance of particles [mm]'
set key outside right top Left reverse samplen 2 spacing 1.25 font ',10' noenhanced
set rmargin 42
set bmargin 8
set label 1 'Intel(R) Xeon(R) Processor; 2 threads, 1 used; commit 12ab06f; κ = 2276; weft_study accuracy, then weft_study plot'."\n".'Not drawn, since they diverged: Explicit Euler substeps=126; Fibres and sets in substeps iterations=1 substeps=4; Fibres and sets iterations=1'."\n".' Fibres and sets iterations=4; Jacobi (Kang): even iterations=2' at screen 0.012, screen 0.085 font ',8' textcolor rgb '#6c757d' noenhanced
$front << END
0.069 760.784 "iterations=1"
0.094 724.245 "iterations=3"
0.107 657.383 "iterations=4"
0.151 566.106 "iterations=8"
0.242 552.955 "iterations=16"
0.413 38.0577 "passes=2"
0.431 37.8509 "passes=1"
0.543 37.1354 "passes=3"
0.548 20.7805 "passes=2"
0.588 18.4842 "passes=3"
0.975 11.7433 "passes=1 substeps=2"
1.112 8.7171 "passes=3 substeps=2"
2.174 4.70669 "passes=1 substeps=4"
2.202 3.81464 "passes=3 substeps=4"
3.869 0.298403 "substeps=126"
11.587 0.270466 "substeps=386"
END
$curve0 << END
0.069 760.784 "iterations=1"
0.094 724.245 "iterations=3"
0.14 683.594 "iterations=7"
0.233 644.915 "iterations=15"
0.413 597.825 "iterations=31"
0.77 579.978 "iterations=63"
1.483 538.755 "iterations=127"
2.957 473.781 "iterations=255"
END
$curve1 << END
0.144 669.333 "iterations=8"
0.233 618.545 "iterations=16"
0.788 530.173 "iterations=64"
END
$curve2 << END
0.106 756.144 "iterations=1"
0.181 637.269 "iterations=7"
0.446 458.079 "iterations=31"
1.507 379.729 "iterations=127"
END
$curve3 << END
0.26 610.681 "iterations=7 substeps=2"
0.528 498.416 "iterations=7 substeps=4"
1.024 338.356 "iterations=7 substeps=8"
2.007 212.747 "iterations=7 substeps=16"
END
$curve4 << END
0.107 657.383 "iterations=4"
0.151 566.106 "iterations=8"
0.242 552.955 "iterations=16"
0.423 410.616 "iterations=32"
0.79 166.382 "iterations=64"
1.495 70.4647 "iterations=128"
END
$curve5 << END
0.147 659.241 "iterations=4"
0.243 594.975 "iterations=8"
0.434 534.568 "iterations=16"
0.812 353.092 "iterations=32"
1.703 116.759 "iterations=64"
3.334 77.3197 "iterations=128"
END
$curve6 << END
0.413 38.0577 "passes=2"
0.431 37.8509 "passes=1"
0.543 37.1354 "passes=3"
0.707 37.0653 "passes=4"
0.996 36.7904 "passes=6"
1.254 36.8019 "passes=8"
1.865 36.8416 "passes=12"
2.666 36.8528 "passes=18"
END
$curve7 << END
0.796 24.6375 "passes=1 substeps=2"
1.624 17.0278 "passes=1 substeps=4"
3.207 11.762 "passes=1 substeps=8"
6.478 7.97706 "passes=1 substeps=16"
END
$curve8 << END
0.548 20.7805 "passes=2"
0.558 21.9646 "passes=1"
0.588 18.4842 "passes=3"
0.737 19.5237 "passes=4"
0.991 18.5708 "passes=6"
1.271 18.4909 "passes=8"
1.841 18.5891 "passes=12"
END
$curve9 << END
0.975 11.7433 "passes=1 substeps=2"
1.112 8.7171 "passes=3 substeps=2"
2.174 4.70669 "passes=1 substeps=4"
2.202 3.81464 "passes=3 substeps=4"
4.041 1.96829 "passes=1 substeps=8"
4.51 1.65883 "passes=3 substeps=8"
END
$curve10 << END
0.173 903.782 "substeps=1"
0.334 836.433 "substeps=2"
0.668 689.671 "substeps=4"
1.304 425.918 "substeps=8"
2.583 160.526 "substeps=16"
5.19 62.1833 "substeps=32"
10.394 28.6824 "substeps=64"
END
$curve11 << END
0.279 839.479 "iterations=4"
0.743 672.822 "iterations=16"
2.47 375.88 "iterations=64"
END
$curve12 << END
0.83 592.186 "iterations=16"
2.987 272.912 "iterations=64"
END
$curve13 << END
2.748 94.8709 "iterations=1 substeps=16"
11.068 13.7412 "iterations=1 substeps=64"
END
$curve14 << END
3.869 0.298403 "substeps=126"
5.87 0.336283 "substeps=193"
11.587 0.270466 "substeps=386"
END
$curve15 << END
15.456 2.45771 "substeps=386"
END
$curve16 << END
151.276 75.5955 "one factorisation a step"
END
$default << END
0.588 18.4842 "passes=3"
END
set terminal svg size 1200,760 font 'DejaVu Sans,13' background rgb 'white'
set output 'accuracy-hanging-64-b-0.5s.svg'
plot $front using 1:2 with lines linewidth 9 linecolor rgb '#ffe8a3' title 'the front: nothing is cheaper and better', \
  36.8294 with lines dashtype 2 linewidth 1.2 linecolor rgb '#495057' title 'backward Euler, converged', \
  18.7122 with lines dashtype 3 linewidth 1.2 linecolor rgb '#495057' title 'BDF2, converged', \
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
set output 'accuracy-hanging-64-b-0.5s.png'
plot $front using 1:2 with lines linewidth 9 linecolor rgb '#ffe8a3' title 'the front: nothing is cheaper and better', \
  36.8294 with lines dashtype 2 linewidth 1.2 linecolor rgb '#495057' title 'backward Euler, converged', \
  18.7122 with lines dashtype 3 linewidth 1.2 linecolor rgb '#495057' title 'BDF2, converged', \
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
