set encoding utf8
set logscale xy
set format '%g'
set border 3 linecolor rgb '#495057'
set tics nomirror
set grid xtics ytics mxtics mytics linetype 1 linewidth 1 linecolor rgb '#dde2e6', linetype 1 linewidth 0.5 linecolor rgb '#eff2f5'
set xrange [0.1365:22.9088]
set yrange [0.596224:4.70075]
set ytics (1, 2)
set title 'T-shirt hung by its neck, 3546 particles: distance from the converged step' noenhanced font ',13'
set xlabel 'median time of a frame of 1/60 s [ms]'
set ylabel 'RMS distance of particles after one step [mm]'
set key outside right top Left reverse samplen 2 spacing 1.25 font ',10' noenhanced
set rmargin 42
set bmargin 8
set label 1 'AMD EPYC; 2 threads, 1 used; commit 3697fc2; κ = 2923; weft_study accuracy, then weft_study plot'."\n".'Not drawn, since they diverged: Chebyshev iterations=128; Chebyshev iterations=16; Chebyshev iterations=32; Chebyshev iterations=4; Chebyshev iterations=64'."\n".' Chebyshev iterations=8; Conjugate gradients iterations=128; Conjugate gradients iterations=16; Conjugate gradients iterations=32'."\n".' Conjugate gradients iterations=4; Conjugate gradients iterations=64; Conjugate gradients iterations=8; Jacobi (Kang) in substeps iterations=7 substeps=16'."\n".' Jacobi (Kang) in substeps iterations=7 substeps=2; Jacobi (Kang) in substeps iterations=7 substeps=4; Jacobi (Kang) in substeps iterations=7 substeps=8'."\n".' Jacobi (Kang) with tethers iterations=1; Jacobi (Kang) with tethers iterations=127; Jacobi (Kang) with tethers iterations=31'."\n".' Jacobi (Kang) with tethers iterations=7; Jacobi (Kang): even iterations=16; Jacobi (Kang): even iterations=2; Jacobi (Kang): even iterations=64'."\n".' Jacobi (Kang): even iterations=8; Jacobi (Kang): odd iterations=1; Jacobi (Kang): odd iterations=127; Jacobi (Kang): odd iterations=15'."\n".' Jacobi (Kang): odd iterations=255; Jacobi (Kang): odd iterations=3; Jacobi (Kang): odd iterations=31; Jacobi (Kang): odd iterations=63'."\n".' Jacobi (Kang): odd iterations=7; Sparse Cholesky one factorisation a step' at screen 0.012, screen 0.085 font ',8' textcolor rgb '#6c757d' noenhanced
$front << END
0.195 2.93797 "substeps=1"
0.247 2.91781 "iterations=1"
0.289 2.88969 "iterations=4"
0.364 2.37011 "substeps=2"
0.492 0.940326 "iterations=1"
0.858 0.905853 "iterations=2"
1.062 0.89705 "passes=2 iterations=1"
1.255 0.887074 "passes=4 iterations=1"
1.332 0.883775 "passes=3 iterations=1"
1.635 0.882399 "passes=2 iterations=2"
1.801 0.87688 "passes=6 iterations=1"
1.947 0.876525 "passes=4 iterations=4"
2.027 0.872244 "iterations=4"
2.362 0.863076 "passes=3 iterations=6"
2.731 0.851749 "iterations=8"
END
$curve0 << END
0.492 0.940326 "iterations=1"
0.858 0.905853 "iterations=2"
2.027 0.872244 "iterations=4"
2.731 0.851749 "iterations=8"
END
$curve1 << END
1.062 0.89705 "passes=2 iterations=1"
1.255 0.887074 "passes=4 iterations=1"
1.332 0.883775 "passes=3 iterations=1"
1.587 0.886786 "passes=4 iterations=2"
1.635 0.882399 "passes=2 iterations=2"
1.657 0.882399 "passes=3 iterations=2"
1.801 0.87688 "passes=6 iterations=1"
1.947 0.876525 "passes=4 iterations=4"
2.036 0.872244 "passes=2 iterations=4"
2.061 0.872354 "passes=3 iterations=4"
2.231 0.877042 "passes=6 iterations=2"
2.362 0.863076 "passes=3 iterations=6"
2.37 0.863076 "passes=2 iterations=6"
2.409 0.869217 "passes=8 iterations=1"
2.929 0.870116 "passes=8 iterations=2"
END
$curve2 << END
1.013 0.919314 "passes=1 substeps=2"
2.005 0.946407 "passes=1 substeps=4"
3.922 1.00933 "passes=1 substeps=8"
7.698 1.08916 "passes=1 substeps=16"
END
$curve3 << END
0.195 2.93797 "substeps=1"
0.364 2.37011 "substeps=2"
0.705 2.21601 "substeps=4"
1.386 2.22025 "substeps=8"
2.743 2.05517 "substeps=16"
5.48 1.65077 "substeps=32"
10.899 1.14047 "substeps=64"
END
$curve4 << END
0.289 2.88969 "iterations=4"
0.657 2.81472 "iterations=16"
2.163 2.65291 "iterations=64"
END
$curve5 << END
0.247 2.91781 "iterations=1"
0.49 2.8441 "iterations=4"
1.485 2.70845 "iterations=16"
5.44 2.41811 "iterations=64"
END
$curve6 << END
0.918 2.16299 "iterations=1 substeps=4"
3.606 1.90518 "iterations=1 substeps=16"
14.318 0.96558 "iterations=1 substeps=64"
END
$default << END
END
set terminal svg size 1200,760 font 'DejaVu Sans,13' background rgb 'white'
set output 'accuracy-tshirt-step.svg'
plot $front using 1:2 with lines linewidth 9 linecolor rgb '#ffe8a3' title 'the front: nothing is cheaper and better', \
  $curve0 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#74c0fc' title 'Multilevel: one linear solve', \
  $curve1 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 5 linecolor rgb '#0b3d91' title 'Multilevel: Newton passes', \
  $curve2 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 8 linecolor rgb '#15aabf' title 'Multilevel in substeps', \
  $curve3 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 7 linecolor rgb '#9c36b5' title 'XPBD: substeps', \
  $curve4 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#da77f2' title 'XPBD: iterations', \
  $curve5 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 13 linecolor rgb '#e64980' title 'Fibres and sets', \
  $curve6 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 12 linecolor rgb '#f783ac' title 'Fibres and sets in substeps', \
  $front using 1:2:3 with labels left offset 0.8,0.6 font ',7' textcolor rgb '#343a40' noenhanced notitle
set terminal pngcairo size 1200,760 font 'DejaVu Sans,10' background rgb 'white'
set output 'accuracy-tshirt-step.png'
plot $front using 1:2 with lines linewidth 9 linecolor rgb '#ffe8a3' title 'the front: nothing is cheaper and better', \
  $curve0 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#74c0fc' title 'Multilevel: one linear solve', \
  $curve1 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 5 linecolor rgb '#0b3d91' title 'Multilevel: Newton passes', \
  $curve2 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 8 linecolor rgb '#15aabf' title 'Multilevel in substeps', \
  $curve3 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 7 linecolor rgb '#9c36b5' title 'XPBD: substeps', \
  $curve4 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 6 linecolor rgb '#da77f2' title 'XPBD: iterations', \
  $curve5 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 13 linecolor rgb '#e64980' title 'Fibres and sets', \
  $curve6 using 1:2 with linespoints linewidth 1.6 pointsize 0.9 pointtype 12 linecolor rgb '#f783ac' title 'Fibres and sets in substeps', \
  $front using 1:2:3 with labels left offset 0.8,0.6 font ',7' textcolor rgb '#343a40' noenhanced notitle
