set encoding utf8
set logscale xy
set format '%g'
set border 3 linecolor rgb '#495057'
set tics nomirror
set grid xtics ytics mxtics mytics linetype 1 linewidth 1 linecolor rgb '#dde2e6', linetype 1 linewidth 0.5 linecolor rgb '#eff2f5'
set xrange [0.0793037:351.134]
set yrange [0.278721:4.65754]
set ytics (0.5, 1, 2)
set title 'T-shirt hung by its neck, 3546 particles: distance from the converged step' noenhanced font ',13'
set xlabel 'median time of a frame of 1/60 s [ms]'
set ylabel 'RMS distance of particles after one step [mm]'
set key outside right top Left reverse samplen 2 spacing 1.25 font ',10' noenhanced
set rmargin 42
set bmargin 5
set label 1 'Intel(R) Xeon(R) Processor; 2 threads, 2 used; commit 05b8bef; κ = 2923; weft_study accuracy, then weft_study plot' at screen 0.012, screen 0.022 font ',8' textcolor rgb '#6c757d' noenhanced
$front << END
0.113291 2.91096 "substeps=1"
0.125949 0.842677 "iterations=1"
0.152594 0.817087 "iterations=2"
0.191915 0.786715 "iterations=4"
0.270642 0.784866 "iterations=8"
0.274643 0.776733 "iterations=8"
0.321035 0.730524 "iterations=1"
0.491038 0.680666 "passes=2 iterations=1"
0.601608 0.639475 "passes=2 iterations=2"
0.745062 0.590583 "passes=3 iterations=2"
0.924697 0.548071 "passes=2 iterations=4"
1.06195 0.543751 "passes=4 iterations=2"
1.11333 0.484975 "passes=3 iterations=4"
1.2172 0.465607 "passes=2 iterations=6"
1.35027 0.43915 "passes=4 iterations=4"
1.4084 0.39986 "passes=3 iterations=6"
29.9501 0.399042 "substeps=641"
40.6327 0.398901 "substeps=641"
43.7698 0.398848 "substeps=985"
87.6725 0.398173 "substeps=1970"
END
$curve0 << END
0.125949 0.842677 "iterations=1"
0.174391 0.827808 "iterations=3"
0.252714 0.808938 "iterations=7"
0.415928 0.789079 "iterations=15"
0.729599 0.771397 "iterations=31"
1.40783 0.757084 "iterations=63"
2.75852 0.7459 "iterations=127"
5.41597 0.740676 "iterations=255"
END
$curve1 << END
0.152594 0.817087 "iterations=2"
0.270642 0.784866 "iterations=8"
0.430389 0.773534 "iterations=16"
1.19549 0.756023 "iterations=64"
END
$curve2 << END
0.14421 0.845417 "iterations=1"
0.277542 0.811827 "iterations=7"
0.708593 0.774474 "iterations=31"
2.71029 0.749277 "iterations=127"
END
$curve3 << END
0.474937 0.787632 "iterations=7 substeps=2"
0.894672 0.752839 "iterations=7 substeps=4"
1.88946 0.696349 "iterations=7 substeps=8"
3.74455 0.593848 "iterations=7 substeps=16"
END
$curve4 << END
0.191915 0.786715 "iterations=4"
0.274643 0.776733 "iterations=8"
0.438625 0.751362 "iterations=16"
0.660742 0.787646 "iterations=32"
1.44798 0.919872 "iterations=64"
2.58303 1.0667 "iterations=128"
END
$curve5 << END
0.233537 0.791136 "iterations=4"
0.381897 0.773354 "iterations=8"
0.721393 0.763992 "iterations=16"
1.29758 0.833765 "iterations=32"
2.50704 0.942952 "iterations=64"
4.65851 0.980265 "iterations=128"
END
$curve6 << END
0.412286 0.730524 "iterations=1"
0.597027 0.697224 "iterations=2"
0.855724 0.687476 "iterations=3"
0.970914 0.666049 "iterations=4"
1.40921 0.637561 "iterations=6"
1.89388 0.601463 "iterations=8"
2.34817 0.530557 "iterations=12"
3.2817 0.463542 "iterations=16"
END
$curve7 << END
0.321035 0.730524 "iterations=1"
0.497153 0.69717 "iterations=2"
0.695462 0.676646 "iterations=4"
1.09536 0.662421 "iterations=8"
END
$curve8 << END
0.491038 0.680666 "passes=2 iterations=1"
0.601608 0.639475 "passes=2 iterations=2"
0.726541 0.639529 "passes=3 iterations=1"
0.745062 0.590583 "passes=3 iterations=2"
0.89962 0.602159 "passes=4 iterations=1"
0.924697 0.548071 "passes=2 iterations=4"
1.06195 0.543751 "passes=4 iterations=2"
1.11333 0.484975 "passes=3 iterations=4"
1.2172 0.465607 "passes=2 iterations=6"
1.35027 0.43915 "passes=4 iterations=4"
1.35485 0.551258 "passes=6 iterations=1"
1.4084 0.39986 "passes=3 iterations=6"
1.43671 0.467205 "passes=6 iterations=2"
1.55434 0.510118 "passes=8 iterations=1"
1.709 0.422292 "passes=8 iterations=2"
END
$curve9 << END
0.607535 0.690283 "passes=1 substeps=2"
1.16467 0.633505 "passes=1 substeps=4"
2.32605 0.514178 "passes=1 substeps=8"
4.70879 0.417209 "passes=1 substeps=16"
END
$curve10 << END
0.113291 2.91096 "substeps=1"
0.203121 2.29939 "substeps=2"
0.392712 2.02404 "substeps=4"
0.753485 1.87959 "substeps=8"
1.51645 1.74729 "substeps=16"
2.9834 1.48464 "substeps=32"
6.32109 1.06538 "substeps=64"
END
$curve11 << END
0.34145 2.87638 "iterations=4"
1.53219 2.79625 "iterations=16"
4.21857 2.54108 "iterations=64"
END
$curve12 << END
0.222708 2.87936 "iterations=1"
0.704866 2.79935 "iterations=4"
2.71466 2.60538 "iterations=16"
11.4883 2.15986 "iterations=64"
END
$curve13 << END
0.817958 1.93293 "iterations=1 substeps=4"
3.62119 1.55365 "iterations=1 substeps=16"
13.4996 0.866572 "iterations=1 substeps=64"
END
$curve14 << END
29.9501 0.399042 "substeps=641"
43.7698 0.398848 "substeps=985"
87.6725 0.398173 "substeps=1970"
END
$curve15 << END
40.6327 0.398901 "substeps=641"
125.118 0.398252 "substeps=1970"
END
$curve16 << END
219.459 1.01552 "one factorisation a step"
END
$default << END
0.745062 0.590583 "passes=3 iterations=2"
END
set terminal svg size 1200,760 font 'DejaVu Sans,13' background rgb 'white'
set output 'accuracy-tshirt-step.svg'
plot $front using 1:2 with lines linewidth 9 linecolor rgb '#ffe8a3' title 'the front: nothing is cheaper and better', \
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
set output 'accuracy-tshirt-step.png'
plot $front using 1:2 with lines linewidth 9 linecolor rgb '#ffe8a3' title 'the front: nothing is cheaper and better', \
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
  $curve10 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 7 linecolor rgb '#9c36b5' title 'XPBD: substeps', \
  $curve11 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#da77f2' title 'XPBD: iterations', \
  $curve12 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 13 linecolor rgb '#e64980' title 'Fibres and sets', \
  $curve13 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 12 linecolor rgb '#f783ac' title 'Fibres and sets in substeps', \
  $curve14 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 15 linecolor rgb '#495057' title 'Symplectic Euler', \
  $curve15 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 14 linecolor rgb '#adb5bd' title 'Explicit Euler', \
  $curve16 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 2 linecolor rgb '#000000' title 'Sparse Cholesky', \
  $front using 1:2:3 with labels left offset 0.8,0.6 font ',7' textcolor rgb '#343a40' noenhanced notitle, \
  $default using 1:2 with points pointtype 3 pointsize 3 linewidth 3 linecolor rgb '#000000' title 'Weft''s default'
