set encoding utf8
set logscale xy
set format '%g'
set border 3 linecolor rgb '#495057'
set tics nomirror
set grid xtics ytics mxtics mytics linetype 1 linewidth 1 linecolor rgb '#dde2e6', linetype 1 linewidth 0.5 linecolor rgb '#eff2f5'
set xrange [0.0483:242.042]
set yrange [0.39508:6499.14]
set title 'Sheet hung by two corners, 64 × 64 particles: distance from converged backward Euler after 1 s' noenhanced font ',13'
set xlabel 'median time of a frame of 1/60 s [ms]'
set ylabel 'RMS distance of particles [mm]'
set key outside right top Left reverse samplen 2 spacing 1.25 font ',10' noenhanced
set rmargin 42
set bmargin 8
set label 1 'Intel(R) Xeon(R) Processor; 2 threads, 1 used; commit 12ab06f; κ = 2276; weft_study accuracy, then weft_study plot'."\n".'Not drawn, since they diverged: Explicit Euler substeps=126; Fibres and sets in substeps iterations=1 substeps=4; Fibres and sets iterations=1'."\n".' Fibres and sets iterations=4; Jacobi (Kang): even iterations=2' at screen 0.012, screen 0.085 font ',8' textcolor rgb '#6c757d' noenhanced
$front << END
0.069 1080.6 "iterations=1"
0.106 1022.18 "iterations=1"
0.144 972.96 "iterations=8"
0.151 936.052 "iterations=8"
0.181 873.229 "iterations=7"
0.242 607.654 "iterations=16"
0.413 18.6596 "passes=2"
0.543 8.19815 "passes=3"
0.707 3.88944 "passes=4"
0.996 2.87872 "passes=6"
1.254 2.31985 "passes=8"
1.865 0.979843 "passes=12"
2.666 0.5644 "passes=18"
END
$curve0 << END
0.069 1080.6 "iterations=1"
0.094 1083.42 "iterations=3"
0.14 1090.43 "iterations=7"
0.233 1068.6 "iterations=15"
0.413 980.053 "iterations=31"
0.77 813.222 "iterations=63"
1.483 662.49 "iterations=127"
2.957 539.463 "iterations=255"
END
$curve1 << END
0.144 972.96 "iterations=8"
0.233 940.762 "iterations=16"
0.788 667.531 "iterations=64"
END
$curve2 << END
0.106 1022.18 "iterations=1"
0.181 873.229 "iterations=7"
0.446 577.821 "iterations=31"
1.507 403.313 "iterations=127"
END
$curve3 << END
0.26 985.638 "iterations=7 substeps=2"
0.528 495.496 "iterations=7 substeps=4"
1.024 123.752 "iterations=7 substeps=8"
2.007 115.091 "iterations=7 substeps=16"
END
$curve4 << END
0.107 1084.87 "iterations=4"
0.151 936.052 "iterations=8"
0.242 607.654 "iterations=16"
0.423 382.918 "iterations=32"
0.79 101.131 "iterations=64"
1.495 57.4762 "iterations=128"
END
$curve5 << END
0.147 1092.83 "iterations=4"
0.243 944.857 "iterations=8"
0.434 649.783 "iterations=16"
0.812 327.193 "iterations=32"
1.703 87.7879 "iterations=64"
3.334 99.1865 "iterations=128"
END
$curve6 << END
0.413 18.6596 "passes=2"
0.431 18.7654 "passes=1"
0.543 8.19815 "passes=3"
0.707 3.88944 "passes=4"
0.996 2.87872 "passes=6"
1.254 2.31985 "passes=8"
1.865 0.979843 "passes=12"
2.666 0.5644 "passes=18"
END
$curve7 << END
0.796 75.0684 "passes=1 substeps=2"
1.624 117.105 "passes=1 substeps=4"
3.207 143.863 "passes=1 substeps=8"
6.478 160.051 "passes=1 substeps=16"
END
$curve8 << END
0.548 178.614 "passes=2"
0.558 184.465 "passes=1"
0.588 180.755 "passes=3"
0.737 176.876 "passes=4"
0.991 175.1 "passes=6"
1.271 175.168 "passes=8"
1.841 174.885 "passes=12"
END
$curve9 << END
0.975 182.258 "passes=1 substeps=2"
1.112 180.175 "passes=3 substeps=2"
2.174 177.448 "passes=1 substeps=4"
2.202 179.998 "passes=3 substeps=4"
4.041 178.014 "passes=1 substeps=8"
4.51 177.885 "passes=3 substeps=8"
END
$curve10 << END
0.173 4061.96 "substeps=1"
0.334 3186.84 "substeps=2"
0.668 1394.26 "substeps=4"
1.304 200.995 "substeps=8"
2.583 129.107 "substeps=16"
5.19 164.21 "substeps=32"
10.394 174.508 "substeps=64"
END
$curve11 << END
0.279 3144.84 "iterations=4"
0.743 1283.04 "iterations=16"
2.47 192.986 "iterations=64"
END
$curve12 << END
0.83 730.179 "iterations=16"
2.987 74.7898 "iterations=64"
END
$curve13 << END
2.748 178.023 "iterations=1 substeps=16"
11.068 176.206 "iterations=1 substeps=64"
END
$curve14 << END
3.869 179.452 "substeps=126"
5.87 179.426 "substeps=193"
11.587 179.101 "substeps=386"
END
$curve15 << END
15.456 182.526 "substeps=386"
END
$curve16 << END
151.276 86.8708 "one factorisation a step"
END
$default << END
0.588 180.755 "passes=3"
END
set terminal svg size 1200,760 font 'DejaVu Sans,13' background rgb 'white'
set output 'accuracy-hanging-64-a-1s.svg'
plot $front using 1:2 with lines linewidth 9 linecolor rgb '#ffe8a3' title 'the front: nothing is cheaper and better', \
  86.8715 with lines dashtype 2 linewidth 1.2 linecolor rgb '#495057' title 'one linearisation, solved exactly', \
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
set output 'accuracy-hanging-64-a-1s.png'
plot $front using 1:2 with lines linewidth 9 linecolor rgb '#ffe8a3' title 'the front: nothing is cheaper and better', \
  86.8715 with lines dashtype 2 linewidth 1.2 linecolor rgb '#495057' title 'one linearisation, solved exactly', \
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
