set encoding utf8
unset border
unset tics
unset key
set margins 0,0,0,0
set xrange [0:1194]
set yrange [0:1172]
set object rectangle from 75,959 to 114.6,935 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 75,985 to 114.6,961 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 75,1011 to 114.6,987 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 75,1037 to 114.6,1013 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 75,1063 to 114.6,1039 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 116.6,959 to 156.2,935 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 116.6,985 to 156.2,961 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 116.6,1011 to 156.2,987 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 116.6,1037 to 156.2,1013 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 116.6,1063 to 156.2,1039 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 158.2,959 to 197.8,935 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 158.2,985 to 197.8,961 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 158.2,1011 to 197.8,987 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 158.2,1037 to 197.8,1013 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 158.2,1063 to 197.8,1039 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 199.8,959 to 239.4,935 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 199.8,985 to 239.4,961 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 199.8,1011 to 239.4,987 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 199.8,1037 to 239.4,1013 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 199.8,1063 to 239.4,1039 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 241.4,959 to 281,935 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 241.4,985 to 281,961 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 241.4,1011 to 281,987 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 241.4,1037 to 281,1013 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 241.4,1063 to 281,1039 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 299,959 to 338.6,935 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 299,985 to 338.6,961 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 299,1011 to 338.6,987 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 299,1037 to 338.6,1013 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 299,1063 to 338.6,1039 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 340.6,959 to 380.2,935 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 340.6,985 to 380.2,961 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 340.6,1011 to 380.2,987 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 340.6,1037 to 380.2,1013 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 340.6,1063 to 380.2,1039 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 382.2,959 to 421.8,935 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 382.2,985 to 421.8,961 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 382.2,1011 to 421.8,987 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 382.2,1037 to 421.8,1013 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 382.2,1063 to 421.8,1039 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 423.8,959 to 463.4,935 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 423.8,985 to 463.4,961 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 423.8,1011 to 463.4,987 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 423.8,1037 to 463.4,1013 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 423.8,1063 to 463.4,1039 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 465.4,959 to 505,935 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 465.4,985 to 505,961 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 465.4,1011 to 505,987 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 465.4,1037 to 505,1013 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 465.4,1063 to 505,1039 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 523,959 to 562.6,935 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 523,985 to 562.6,961 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 523,1011 to 562.6,987 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 523,1037 to 562.6,1013 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 523,1063 to 562.6,1039 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 564.6,959 to 604.2,935 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 564.6,985 to 604.2,961 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 564.6,1011 to 604.2,987 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 564.6,1037 to 604.2,1013 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 564.6,1063 to 604.2,1039 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 606.2,959 to 645.8,935 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 606.2,985 to 645.8,961 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 606.2,1011 to 645.8,987 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 606.2,1037 to 645.8,1013 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 606.2,1063 to 645.8,1039 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 647.8,959 to 687.4,935 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 647.8,985 to 687.4,961 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 647.8,1011 to 687.4,987 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 647.8,1037 to 687.4,1013 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 647.8,1063 to 687.4,1039 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 689.4,959 to 729,935 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 689.4,985 to 729,961 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 689.4,1011 to 729,987 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 689.4,1037 to 729,1013 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 689.4,1063 to 729,1039 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 747,959 to 786.6,935 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 747,985 to 786.6,961 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 747,1011 to 786.6,987 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 747,1037 to 786.6,1013 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 747,1063 to 786.6,1039 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 788.6,959 to 828.2,935 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 788.6,985 to 828.2,961 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 788.6,1011 to 828.2,987 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 788.6,1037 to 828.2,1013 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 788.6,1063 to 828.2,1039 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 830.2,959 to 869.8,935 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 830.2,985 to 869.8,961 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 830.2,1011 to 869.8,987 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 830.2,1037 to 869.8,1013 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 830.2,1063 to 869.8,1039 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 871.8,959 to 911.4,935 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 871.8,985 to 911.4,961 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 871.8,1011 to 911.4,987 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 871.8,1037 to 911.4,1013 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 871.8,1063 to 911.4,1039 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 913.4,959 to 953,935 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 913.4,985 to 953,961 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 913.4,1011 to 953,987 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 913.4,1037 to 953,1013 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 913.4,1063 to 953,1039 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 971,959 to 1010.6,935 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 971,985 to 1010.6,961 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 971,1011 to 1010.6,987 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 971,1037 to 1010.6,1013 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 971,1063 to 1010.6,1039 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 1012.6,959 to 1052.2,935 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 1012.6,985 to 1052.2,961 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 1012.6,1011 to 1052.2,987 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 1012.6,1037 to 1052.2,1013 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 1012.6,1063 to 1052.2,1039 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 1054.2,959 to 1093.8,935 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 1054.2,985 to 1093.8,961 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 1054.2,1011 to 1093.8,987 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 1054.2,1037 to 1093.8,1013 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 1054.2,1063 to 1093.8,1039 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 1095.8,959 to 1135.4,935 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 1095.8,985 to 1135.4,961 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 1095.8,1011 to 1135.4,987 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 1095.8,1037 to 1135.4,1013 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 1095.8,1063 to 1135.4,1039 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 1137.4,959 to 1177,935 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 1137.4,985 to 1177,961 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 1137.4,1011 to 1177,987 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 1137.4,1037 to 1177,1013 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 1137.4,1063 to 1177,1039 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 75,783 to 114.6,759 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 75,809 to 114.6,785 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 75,835 to 114.6,811 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 75,861 to 114.6,837 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 75,887 to 114.6,863 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 116.6,783 to 156.2,759 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 116.6,809 to 156.2,785 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 116.6,835 to 156.2,811 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 116.6,861 to 156.2,837 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 116.6,887 to 156.2,863 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 158.2,783 to 197.8,759 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 158.2,809 to 197.8,785 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 158.2,835 to 197.8,811 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 158.2,861 to 197.8,837 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 158.2,887 to 197.8,863 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 199.8,783 to 239.4,759 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 199.8,809 to 239.4,785 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 199.8,835 to 239.4,811 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 199.8,861 to 239.4,837 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 199.8,887 to 239.4,863 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 241.4,783 to 281,759 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 241.4,809 to 281,785 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 241.4,835 to 281,811 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 241.4,861 to 281,837 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 241.4,887 to 281,863 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 299,783 to 338.6,759 fillcolor rgb '#c6453f' fillstyle solid noborder
set object rectangle from 299,809 to 338.6,785 fillcolor rgb '#c6453f' fillstyle solid noborder
set object rectangle from 299,835 to 338.6,811 fillcolor rgb '#c6453f' fillstyle solid noborder
set object rectangle from 299,861 to 338.6,837 fillcolor rgb '#c6453f' fillstyle solid noborder
set object rectangle from 299,887 to 338.6,863 fillcolor rgb '#c6453f' fillstyle solid noborder
set object rectangle from 340.6,783 to 380.2,759 fillcolor rgb '#c6453f' fillstyle solid noborder
set object rectangle from 340.6,809 to 380.2,785 fillcolor rgb '#c6453f' fillstyle solid noborder
set object rectangle from 340.6,835 to 380.2,811 fillcolor rgb '#c6453f' fillstyle solid noborder
set object rectangle from 340.6,861 to 380.2,837 fillcolor rgb '#c6453f' fillstyle solid noborder
set object rectangle from 340.6,887 to 380.2,863 fillcolor rgb '#c6453f' fillstyle solid noborder
set object rectangle from 382.2,783 to 421.8,759 fillcolor rgb '#c6453f' fillstyle solid noborder
set object rectangle from 382.2,809 to 421.8,785 fillcolor rgb '#c6453f' fillstyle solid noborder
set object rectangle from 382.2,835 to 421.8,811 fillcolor rgb '#c6453f' fillstyle solid noborder
set object rectangle from 382.2,861 to 421.8,837 fillcolor rgb '#c6453f' fillstyle solid noborder
set object rectangle from 382.2,887 to 421.8,863 fillcolor rgb '#c6453f' fillstyle solid noborder
set object rectangle from 423.8,783 to 463.4,759 fillcolor rgb '#c6453f' fillstyle solid noborder
set object rectangle from 423.8,809 to 463.4,785 fillcolor rgb '#c6453f' fillstyle solid noborder
set object rectangle from 423.8,835 to 463.4,811 fillcolor rgb '#c6453f' fillstyle solid noborder
set object rectangle from 423.8,861 to 463.4,837 fillcolor rgb '#c6453f' fillstyle solid noborder
set object rectangle from 423.8,887 to 463.4,863 fillcolor rgb '#c6453f' fillstyle solid noborder
set object rectangle from 465.4,783 to 505,759 fillcolor rgb '#c6453f' fillstyle solid noborder
set object rectangle from 465.4,809 to 505,785 fillcolor rgb '#c6453f' fillstyle solid noborder
set object rectangle from 465.4,835 to 505,811 fillcolor rgb '#c6453f' fillstyle solid noborder
set object rectangle from 465.4,861 to 505,837 fillcolor rgb '#c6453f' fillstyle solid noborder
set object rectangle from 465.4,887 to 505,863 fillcolor rgb '#c6453f' fillstyle solid noborder
set object rectangle from 523,783 to 562.6,759 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 523,809 to 562.6,785 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 523,835 to 562.6,811 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 523,861 to 562.6,837 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 523,887 to 562.6,863 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 564.6,783 to 604.2,759 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 564.6,809 to 604.2,785 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 564.6,835 to 604.2,811 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 564.6,861 to 604.2,837 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 564.6,887 to 604.2,863 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 606.2,783 to 645.8,759 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 606.2,809 to 645.8,785 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 606.2,835 to 645.8,811 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 606.2,861 to 645.8,837 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 606.2,887 to 645.8,863 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 647.8,783 to 687.4,759 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 647.8,809 to 687.4,785 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 647.8,835 to 687.4,811 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 647.8,861 to 687.4,837 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 647.8,887 to 687.4,863 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 689.4,783 to 729,759 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 689.4,809 to 729,785 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 689.4,835 to 729,811 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 689.4,861 to 729,837 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 689.4,887 to 729,863 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 747,783 to 786.6,759 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 747,809 to 786.6,785 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 747,835 to 786.6,811 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 747,861 to 786.6,837 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 747,887 to 786.6,863 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 788.6,783 to 828.2,759 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 788.6,809 to 828.2,785 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 788.6,835 to 828.2,811 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 788.6,861 to 828.2,837 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 788.6,887 to 828.2,863 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 830.2,783 to 869.8,759 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 830.2,809 to 869.8,785 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 830.2,835 to 869.8,811 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 830.2,861 to 869.8,837 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 830.2,887 to 869.8,863 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 871.8,783 to 911.4,759 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 871.8,809 to 911.4,785 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 871.8,835 to 911.4,811 fillcolor rgb '#c6453f' fillstyle solid noborder
set object rectangle from 871.8,861 to 911.4,837 fillcolor rgb '#c6453f' fillstyle solid noborder
set object rectangle from 871.8,887 to 911.4,863 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 913.4,783 to 953,759 fillcolor rgb '#c6453f' fillstyle solid noborder
set object rectangle from 913.4,809 to 953,785 fillcolor rgb '#c6453f' fillstyle solid noborder
set object rectangle from 913.4,835 to 953,811 fillcolor rgb '#c6453f' fillstyle solid noborder
set object rectangle from 913.4,861 to 953,837 fillcolor rgb '#c6453f' fillstyle solid noborder
set object rectangle from 913.4,887 to 953,863 fillcolor rgb '#c6453f' fillstyle solid noborder
set object rectangle from 971,783 to 1010.6,759 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 971,809 to 1010.6,785 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 971,835 to 1010.6,811 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 971,861 to 1010.6,837 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 971,887 to 1010.6,863 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 1012.6,783 to 1052.2,759 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 1012.6,809 to 1052.2,785 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 1012.6,835 to 1052.2,811 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 1012.6,861 to 1052.2,837 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 1012.6,887 to 1052.2,863 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 1054.2,783 to 1093.8,759 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 1054.2,809 to 1093.8,785 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 1054.2,835 to 1093.8,811 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 1054.2,861 to 1093.8,837 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 1054.2,887 to 1093.8,863 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 1095.8,783 to 1135.4,759 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 1095.8,809 to 1135.4,785 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 1095.8,835 to 1135.4,811 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 1095.8,861 to 1135.4,837 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 1095.8,887 to 1135.4,863 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 1137.4,783 to 1177,759 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 1137.4,809 to 1177,785 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 1137.4,835 to 1177,811 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 1137.4,861 to 1177,837 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 1137.4,887 to 1177,863 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 75,607 to 114.6,583 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 75,633 to 114.6,609 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 75,659 to 114.6,635 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 75,685 to 114.6,661 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 75,711 to 114.6,687 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 116.6,607 to 156.2,583 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 116.6,633 to 156.2,609 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 116.6,659 to 156.2,635 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 116.6,685 to 156.2,661 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 116.6,711 to 156.2,687 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 158.2,607 to 197.8,583 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 158.2,633 to 197.8,609 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 158.2,659 to 197.8,635 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 158.2,685 to 197.8,661 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 158.2,711 to 197.8,687 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 199.8,607 to 239.4,583 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 199.8,633 to 239.4,609 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 199.8,659 to 239.4,635 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 199.8,685 to 239.4,661 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 199.8,711 to 239.4,687 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 241.4,607 to 281,583 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 241.4,633 to 281,609 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 241.4,659 to 281,635 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 241.4,685 to 281,661 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 241.4,711 to 281,687 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 299,607 to 338.6,583 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 299,633 to 338.6,609 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 299,659 to 338.6,635 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 299,685 to 338.6,661 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 299,711 to 338.6,687 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 340.6,607 to 380.2,583 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 340.6,633 to 380.2,609 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 340.6,659 to 380.2,635 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 340.6,685 to 380.2,661 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 340.6,711 to 380.2,687 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 382.2,607 to 421.8,583 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 382.2,633 to 421.8,609 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 382.2,659 to 421.8,635 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 382.2,685 to 421.8,661 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 382.2,711 to 421.8,687 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 423.8,607 to 463.4,583 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 423.8,633 to 463.4,609 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 423.8,659 to 463.4,635 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 423.8,685 to 463.4,661 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 423.8,711 to 463.4,687 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 465.4,607 to 505,583 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 465.4,633 to 505,609 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 465.4,659 to 505,635 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 465.4,685 to 505,661 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 465.4,711 to 505,687 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 523,607 to 562.6,583 fillcolor rgb '#c6453f' fillstyle solid noborder
set object rectangle from 523,633 to 562.6,609 fillcolor rgb '#c6453f' fillstyle solid noborder
set object rectangle from 523,659 to 562.6,635 fillcolor rgb '#c6453f' fillstyle solid noborder
set object rectangle from 523,685 to 562.6,661 fillcolor rgb '#c6453f' fillstyle solid noborder
set object rectangle from 523,711 to 562.6,687 fillcolor rgb '#c6453f' fillstyle solid noborder
set object rectangle from 564.6,607 to 604.2,583 fillcolor rgb '#c6453f' fillstyle solid noborder
set object rectangle from 564.6,633 to 604.2,609 fillcolor rgb '#c6453f' fillstyle solid noborder
set object rectangle from 564.6,659 to 604.2,635 fillcolor rgb '#c6453f' fillstyle solid noborder
set object rectangle from 564.6,685 to 604.2,661 fillcolor rgb '#c6453f' fillstyle solid noborder
set object rectangle from 564.6,711 to 604.2,687 fillcolor rgb '#c6453f' fillstyle solid noborder
set object rectangle from 606.2,607 to 645.8,583 fillcolor rgb '#c6453f' fillstyle solid noborder
set object rectangle from 606.2,633 to 645.8,609 fillcolor rgb '#c6453f' fillstyle solid noborder
set object rectangle from 606.2,659 to 645.8,635 fillcolor rgb '#c6453f' fillstyle solid noborder
set object rectangle from 606.2,685 to 645.8,661 fillcolor rgb '#c6453f' fillstyle solid noborder
set object rectangle from 606.2,711 to 645.8,687 fillcolor rgb '#c6453f' fillstyle solid noborder
set object rectangle from 647.8,607 to 687.4,583 fillcolor rgb '#c6453f' fillstyle solid noborder
set object rectangle from 647.8,633 to 687.4,609 fillcolor rgb '#c6453f' fillstyle solid noborder
set object rectangle from 647.8,659 to 687.4,635 fillcolor rgb '#c6453f' fillstyle solid noborder
set object rectangle from 647.8,685 to 687.4,661 fillcolor rgb '#c6453f' fillstyle solid noborder
set object rectangle from 647.8,711 to 687.4,687 fillcolor rgb '#c6453f' fillstyle solid noborder
set object rectangle from 689.4,607 to 729,583 fillcolor rgb '#c6453f' fillstyle solid noborder
set object rectangle from 689.4,633 to 729,609 fillcolor rgb '#c6453f' fillstyle solid noborder
set object rectangle from 689.4,659 to 729,635 fillcolor rgb '#c6453f' fillstyle solid noborder
set object rectangle from 689.4,685 to 729,661 fillcolor rgb '#c6453f' fillstyle solid noborder
set object rectangle from 689.4,711 to 729,687 fillcolor rgb '#c6453f' fillstyle solid noborder
set object rectangle from 747,607 to 786.6,583 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 747,633 to 786.6,609 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 747,659 to 786.6,635 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 747,685 to 786.6,661 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 747,711 to 786.6,687 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 788.6,607 to 828.2,583 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 788.6,633 to 828.2,609 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 788.6,659 to 828.2,635 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 788.6,685 to 828.2,661 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 788.6,711 to 828.2,687 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 830.2,607 to 869.8,583 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 830.2,633 to 869.8,609 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 830.2,659 to 869.8,635 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 830.2,685 to 869.8,661 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 830.2,711 to 869.8,687 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 871.8,607 to 911.4,583 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 871.8,633 to 911.4,609 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 871.8,659 to 911.4,635 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 871.8,685 to 911.4,661 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 871.8,711 to 911.4,687 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 913.4,607 to 953,583 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 913.4,633 to 953,609 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 913.4,659 to 953,635 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 913.4,685 to 953,661 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 913.4,711 to 953,687 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 971,607 to 1010.6,583 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 971,633 to 1010.6,609 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 971,659 to 1010.6,635 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 971,685 to 1010.6,661 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 971,711 to 1010.6,687 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 1012.6,607 to 1052.2,583 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 1012.6,633 to 1052.2,609 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 1012.6,659 to 1052.2,635 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 1012.6,685 to 1052.2,661 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 1012.6,711 to 1052.2,687 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 1054.2,607 to 1093.8,583 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 1054.2,633 to 1093.8,609 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 1054.2,659 to 1093.8,635 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 1054.2,685 to 1093.8,661 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 1054.2,711 to 1093.8,687 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 1095.8,607 to 1135.4,583 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 1095.8,633 to 1135.4,609 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 1095.8,659 to 1135.4,635 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 1095.8,685 to 1135.4,661 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 1095.8,711 to 1135.4,687 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 1137.4,607 to 1177,583 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 1137.4,633 to 1177,609 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 1137.4,659 to 1177,635 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 1137.4,685 to 1177,661 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 1137.4,711 to 1177,687 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 75,431 to 114.6,407 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 75,457 to 114.6,433 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 75,483 to 114.6,459 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 75,509 to 114.6,485 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 75,535 to 114.6,511 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 116.6,431 to 156.2,407 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 116.6,457 to 156.2,433 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 116.6,483 to 156.2,459 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 116.6,509 to 156.2,485 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 116.6,535 to 156.2,511 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 158.2,431 to 197.8,407 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 158.2,457 to 197.8,433 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 158.2,483 to 197.8,459 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 158.2,509 to 197.8,485 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 158.2,535 to 197.8,511 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 199.8,431 to 239.4,407 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 199.8,457 to 239.4,433 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 199.8,483 to 239.4,459 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 199.8,509 to 239.4,485 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 199.8,535 to 239.4,511 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 241.4,431 to 281,407 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 241.4,457 to 281,433 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 241.4,483 to 281,459 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 241.4,509 to 281,485 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 241.4,535 to 281,511 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 299,431 to 338.6,407 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 299,457 to 338.6,433 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 299,483 to 338.6,459 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 299,509 to 338.6,485 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 299,535 to 338.6,511 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 340.6,431 to 380.2,407 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 340.6,457 to 380.2,433 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 340.6,483 to 380.2,459 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 340.6,509 to 380.2,485 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 340.6,535 to 380.2,511 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 382.2,431 to 421.8,407 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 382.2,457 to 421.8,433 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 382.2,483 to 421.8,459 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 382.2,509 to 421.8,485 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 382.2,535 to 421.8,511 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 423.8,431 to 463.4,407 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 423.8,457 to 463.4,433 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 423.8,483 to 463.4,459 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 423.8,509 to 463.4,485 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 423.8,535 to 463.4,511 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 465.4,431 to 505,407 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 465.4,457 to 505,433 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 465.4,483 to 505,459 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 465.4,509 to 505,485 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 465.4,535 to 505,511 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 523,431 to 562.6,407 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 523,457 to 562.6,433 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 523,483 to 562.6,459 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 523,509 to 562.6,485 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 523,535 to 562.6,511 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 564.6,431 to 604.2,407 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 564.6,457 to 604.2,433 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 564.6,483 to 604.2,459 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 564.6,509 to 604.2,485 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 564.6,535 to 604.2,511 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 606.2,431 to 645.8,407 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 606.2,457 to 645.8,433 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 606.2,483 to 645.8,459 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 606.2,509 to 645.8,485 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 606.2,535 to 645.8,511 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 647.8,431 to 687.4,407 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 647.8,457 to 687.4,433 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 647.8,483 to 687.4,459 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 647.8,509 to 687.4,485 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 647.8,535 to 687.4,511 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 689.4,431 to 729,407 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 689.4,457 to 729,433 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 689.4,483 to 729,459 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 689.4,509 to 729,485 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 689.4,535 to 729,511 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 747,431 to 786.6,407 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 747,457 to 786.6,433 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 747,483 to 786.6,459 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 747,509 to 786.6,485 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 747,535 to 786.6,511 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 788.6,431 to 828.2,407 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 788.6,457 to 828.2,433 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 788.6,483 to 828.2,459 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 788.6,509 to 828.2,485 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 788.6,535 to 828.2,511 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 830.2,431 to 869.8,407 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 830.2,457 to 869.8,433 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 830.2,483 to 869.8,459 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 830.2,509 to 869.8,485 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 830.2,535 to 869.8,511 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 871.8,431 to 911.4,407 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 871.8,457 to 911.4,433 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 871.8,483 to 911.4,459 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 871.8,509 to 911.4,485 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 871.8,535 to 911.4,511 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 913.4,431 to 953,407 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 913.4,457 to 953,433 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 913.4,483 to 953,459 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 913.4,509 to 953,485 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 913.4,535 to 953,511 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 971,431 to 1010.6,407 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 971,457 to 1010.6,433 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 971,483 to 1010.6,459 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 971,509 to 1010.6,485 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 971,535 to 1010.6,511 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 1012.6,431 to 1052.2,407 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 1012.6,457 to 1052.2,433 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 1012.6,483 to 1052.2,459 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 1012.6,509 to 1052.2,485 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 1012.6,535 to 1052.2,511 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 1054.2,431 to 1093.8,407 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 1054.2,457 to 1093.8,433 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 1054.2,483 to 1093.8,459 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 1054.2,509 to 1093.8,485 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 1054.2,535 to 1093.8,511 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 1095.8,431 to 1135.4,407 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 1095.8,457 to 1135.4,433 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 1095.8,483 to 1135.4,459 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 1095.8,509 to 1135.4,485 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 1095.8,535 to 1135.4,511 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 1137.4,431 to 1177,407 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 1137.4,457 to 1177,433 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 1137.4,483 to 1177,459 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 1137.4,509 to 1177,485 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 1137.4,535 to 1177,511 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 75,255 to 114.6,231 fillcolor rgb '#c6453f' fillstyle solid noborder
set object rectangle from 75,281 to 114.6,257 fillcolor rgb '#c6453f' fillstyle solid noborder
set object rectangle from 75,307 to 114.6,283 fillcolor rgb '#c6453f' fillstyle solid noborder
set object rectangle from 75,333 to 114.6,309 fillcolor rgb '#c6453f' fillstyle solid noborder
set object rectangle from 75,359 to 114.6,335 fillcolor rgb '#c6453f' fillstyle solid noborder
set object rectangle from 116.6,255 to 156.2,231 fillcolor rgb '#c6453f' fillstyle solid noborder
set object rectangle from 116.6,281 to 156.2,257 fillcolor rgb '#c6453f' fillstyle solid noborder
set object rectangle from 116.6,307 to 156.2,283 fillcolor rgb '#c6453f' fillstyle solid noborder
set object rectangle from 116.6,333 to 156.2,309 fillcolor rgb '#c6453f' fillstyle solid noborder
set object rectangle from 116.6,359 to 156.2,335 fillcolor rgb '#c6453f' fillstyle solid noborder
set object rectangle from 158.2,255 to 197.8,231 fillcolor rgb '#c6453f' fillstyle solid noborder
set object rectangle from 158.2,281 to 197.8,257 fillcolor rgb '#c6453f' fillstyle solid noborder
set object rectangle from 158.2,307 to 197.8,283 fillcolor rgb '#c6453f' fillstyle solid noborder
set object rectangle from 158.2,333 to 197.8,309 fillcolor rgb '#c6453f' fillstyle solid noborder
set object rectangle from 158.2,359 to 197.8,335 fillcolor rgb '#c6453f' fillstyle solid noborder
set object rectangle from 199.8,255 to 239.4,231 fillcolor rgb '#c6453f' fillstyle solid noborder
set object rectangle from 199.8,281 to 239.4,257 fillcolor rgb '#c6453f' fillstyle solid noborder
set object rectangle from 199.8,307 to 239.4,283 fillcolor rgb '#c6453f' fillstyle solid noborder
set object rectangle from 199.8,333 to 239.4,309 fillcolor rgb '#c6453f' fillstyle solid noborder
set object rectangle from 199.8,359 to 239.4,335 fillcolor rgb '#c6453f' fillstyle solid noborder
set object rectangle from 241.4,255 to 281,231 fillcolor rgb '#c6453f' fillstyle solid noborder
set object rectangle from 241.4,281 to 281,257 fillcolor rgb '#c6453f' fillstyle solid noborder
set object rectangle from 241.4,307 to 281,283 fillcolor rgb '#c6453f' fillstyle solid noborder
set object rectangle from 241.4,333 to 281,309 fillcolor rgb '#c6453f' fillstyle solid noborder
set object rectangle from 241.4,359 to 281,335 fillcolor rgb '#c6453f' fillstyle solid noborder
set object rectangle from 299,255 to 338.6,231 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 299,281 to 338.6,257 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 299,307 to 338.6,283 fillcolor rgb '#c6453f' fillstyle solid noborder
set object rectangle from 299,333 to 338.6,309 fillcolor rgb '#c6453f' fillstyle solid noborder
set object rectangle from 299,359 to 338.6,335 fillcolor rgb '#c6453f' fillstyle solid noborder
set object rectangle from 340.6,255 to 380.2,231 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 340.6,281 to 380.2,257 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 340.6,307 to 380.2,283 fillcolor rgb '#c6453f' fillstyle solid noborder
set object rectangle from 340.6,333 to 380.2,309 fillcolor rgb '#c6453f' fillstyle solid noborder
set object rectangle from 340.6,359 to 380.2,335 fillcolor rgb '#c6453f' fillstyle solid noborder
set object rectangle from 382.2,255 to 421.8,231 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 382.2,281 to 421.8,257 fillcolor rgb '#c6453f' fillstyle solid noborder
set object rectangle from 382.2,307 to 421.8,283 fillcolor rgb '#c6453f' fillstyle solid noborder
set object rectangle from 382.2,333 to 421.8,309 fillcolor rgb '#c6453f' fillstyle solid noborder
set object rectangle from 382.2,359 to 421.8,335 fillcolor rgb '#c6453f' fillstyle solid noborder
set object rectangle from 423.8,255 to 463.4,231 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 423.8,281 to 463.4,257 fillcolor rgb '#c6453f' fillstyle solid noborder
set object rectangle from 423.8,307 to 463.4,283 fillcolor rgb '#c6453f' fillstyle solid noborder
set object rectangle from 423.8,333 to 463.4,309 fillcolor rgb '#c6453f' fillstyle solid noborder
set object rectangle from 423.8,359 to 463.4,335 fillcolor rgb '#c6453f' fillstyle solid noborder
set object rectangle from 465.4,255 to 505,231 fillcolor rgb '#c6453f' fillstyle solid noborder
set object rectangle from 465.4,281 to 505,257 fillcolor rgb '#c6453f' fillstyle solid noborder
set object rectangle from 465.4,307 to 505,283 fillcolor rgb '#c6453f' fillstyle solid noborder
set object rectangle from 465.4,333 to 505,309 fillcolor rgb '#c6453f' fillstyle solid noborder
set object rectangle from 465.4,359 to 505,335 fillcolor rgb '#c6453f' fillstyle solid noborder
set object rectangle from 523,255 to 562.6,231 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 523,281 to 562.6,257 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 523,307 to 562.6,283 fillcolor rgb '#c6453f' fillstyle solid noborder
set object rectangle from 523,333 to 562.6,309 fillcolor rgb '#c6453f' fillstyle solid noborder
set object rectangle from 523,359 to 562.6,335 fillcolor rgb '#c6453f' fillstyle solid noborder
set object rectangle from 564.6,255 to 604.2,231 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 564.6,281 to 604.2,257 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 564.6,307 to 604.2,283 fillcolor rgb '#c6453f' fillstyle solid noborder
set object rectangle from 564.6,333 to 604.2,309 fillcolor rgb '#c6453f' fillstyle solid noborder
set object rectangle from 564.6,359 to 604.2,335 fillcolor rgb '#c6453f' fillstyle solid noborder
set object rectangle from 606.2,255 to 645.8,231 fillcolor rgb '#c6453f' fillstyle solid noborder
set object rectangle from 606.2,281 to 645.8,257 fillcolor rgb '#c6453f' fillstyle solid noborder
set object rectangle from 606.2,307 to 645.8,283 fillcolor rgb '#c6453f' fillstyle solid noborder
set object rectangle from 606.2,333 to 645.8,309 fillcolor rgb '#c6453f' fillstyle solid noborder
set object rectangle from 606.2,359 to 645.8,335 fillcolor rgb '#c6453f' fillstyle solid noborder
set object rectangle from 647.8,255 to 687.4,231 fillcolor rgb '#c6453f' fillstyle solid noborder
set object rectangle from 647.8,281 to 687.4,257 fillcolor rgb '#c6453f' fillstyle solid noborder
set object rectangle from 647.8,307 to 687.4,283 fillcolor rgb '#c6453f' fillstyle solid noborder
set object rectangle from 647.8,333 to 687.4,309 fillcolor rgb '#c6453f' fillstyle solid noborder
set object rectangle from 647.8,359 to 687.4,335 fillcolor rgb '#c6453f' fillstyle solid noborder
set object rectangle from 689.4,255 to 729,231 fillcolor rgb '#c6453f' fillstyle solid noborder
set object rectangle from 689.4,281 to 729,257 fillcolor rgb '#c6453f' fillstyle solid noborder
set object rectangle from 689.4,307 to 729,283 fillcolor rgb '#c6453f' fillstyle solid noborder
set object rectangle from 689.4,333 to 729,309 fillcolor rgb '#c6453f' fillstyle solid noborder
set object rectangle from 689.4,359 to 729,335 fillcolor rgb '#c6453f' fillstyle solid noborder
set object rectangle from 74,174 to 98,159 fillcolor rgb '#58b08a' fillstyle solid noborder
set object rectangle from 74,153 to 98,138 fillcolor rgb '#f6d36b' fillstyle solid noborder
set object rectangle from 74,69 to 98,54 fillcolor rgb '#c6453f' fillstyle solid noborder
set object rectangle from 74,48 to 98,33 fillcolor rgb '#2b1a33' fillstyle solid noborder
set terminal svg size 1194,1172 font 'DejaVu Sans,13' background rgb 'white'
set output 'stability-flat.svg'
scale = GPVAL_TERM eq 'svg' ? 4.0 / 3 : 1
set label 1 '{/:Bold Where methods fail, from a flat start}' at 74,1148 left font sprintf(',%g', scale * 15) textcolor rgb '#111111' front
set label 2 'A sheet of 24 x 24 particles, 1 m, 0.2 kg/m², hung by two corners, 2 s. Across: the frame''s step [s]. Upwards: stiffness, times 400 N/m.' at 74,1124 left font sprintf(',%g', scale * 10) textcolor rgb '#666666' noenhanced front
set label 3 '{/:Bold Weft''s default}' at 74,1076 left font sprintf(',%g', scale * 10) textcolor rgb '#111111' front
set label 4 'H' at 178,1025 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 5 'H' at 219.6,1025 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 6 'H' at 219.6,1051 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 7 'H' at 261.2,999 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 8 'H' at 261.2,1025 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 9 'H' at 261.2,1051 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 10 'x 10000' at 68,1051 right font sprintf(',%g', scale * 9) textcolor rgb '#666666' noenhanced front
set label 11 'x 1000' at 68,1025 right font sprintf(',%g', scale * 9) textcolor rgb '#666666' noenhanced front
set label 12 'x 100' at 68,999 right font sprintf(',%g', scale * 9) textcolor rgb '#666666' noenhanced front
set label 13 'x 10' at 68,973 right font sprintf(',%g', scale * 9) textcolor rgb '#666666' noenhanced front
set label 14 'x 1' at 68,947 right font sprintf(',%g', scale * 9) textcolor rgb '#666666' noenhanced front
set label 15 'Multilevel: 1 pass' at 298,1076 left font sprintf(',%g', scale * 10) textcolor rgb '#111111' noenhanced front
set label 16 'H' at 402,1051 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 17 'H' at 443.6,1025 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 18 'H' at 443.6,1051 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 19 'H' at 485.2,999 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 20 'H' at 485.2,1025 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 21 'EH' at 485.2,1051 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 22 'Multilevel: 2 passes' at 522,1076 left font sprintf(',%g', scale * 10) textcolor rgb '#111111' noenhanced front
set label 23 'H' at 626,1051 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 24 'H' at 667.6,1025 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 25 'H' at 667.6,1051 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 26 'H' at 709.2,999 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 27 'H' at 709.2,1025 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 28 'H' at 709.2,1051 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 29 'Multilevel: 3 passes; BDF2' at 746,1076 left font sprintf(',%g', scale * 10) textcolor rgb '#111111' noenhanced front
set label 30 'H' at 850,1025 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 31 'H' at 891.6,1025 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 32 'H' at 891.6,1051 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 33 'H' at 933.2,999 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 34 'H' at 933.2,1025 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 35 'H' at 933.2,1051 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 36 'Multilevel: 2 passes; BDF2' at 970,1076 left font sprintf(',%g', scale * 10) textcolor rgb '#111111' noenhanced front
set label 37 'H' at 1115.6,1025 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 38 'H' at 1115.6,1051 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 39 'H' at 1157.2,999 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 40 'H' at 1157.2,1025 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 41 'H' at 1157.2,1051 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 42 'Multilevel: 6 passes' at 74,900 left font sprintf(',%g', scale * 10) textcolor rgb '#111111' noenhanced front
set label 43 'H' at 261.2,849 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 44 'H' at 261.2,875 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 45 'x 10000' at 68,875 right font sprintf(',%g', scale * 9) textcolor rgb '#666666' noenhanced front
set label 46 'x 1000' at 68,849 right font sprintf(',%g', scale * 9) textcolor rgb '#666666' noenhanced front
set label 47 'x 100' at 68,823 right font sprintf(',%g', scale * 9) textcolor rgb '#666666' noenhanced front
set label 48 'x 10' at 68,797 right font sprintf(',%g', scale * 9) textcolor rgb '#666666' noenhanced front
set label 49 'x 1' at 68,771 right font sprintf(',%g', scale * 9) textcolor rgb '#666666' noenhanced front
set label 50 'Jacobi: first guess alone' at 298,900 left font sprintf(',%g', scale * 10) textcolor rgb '#111111' noenhanced front
set label 51 'Jacobi: 1 iteration' at 522,900 left font sprintf(',%g', scale * 10) textcolor rgb '#111111' noenhanced front
set label 52 'E' at 542.8,797 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 53 'E' at 542.8,823 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 54 'EH' at 542.8,849 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 55 'H' at 542.8,875 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 56 'E' at 584.4,771 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 57 'E' at 584.4,797 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 58 'EH' at 584.4,823 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 59 'EH' at 584.4,849 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 60 'H' at 584.4,875 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 61 'E' at 626,771 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 62 'EH' at 626,797 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 63 'EH' at 626,823 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 64 'H' at 626,849 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 65 'H' at 626,875 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 66 'ESH' at 667.6,771 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 67 'ESH' at 667.6,797 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 68 'EH' at 667.6,823 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 69 'H' at 667.6,849 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 70 'H' at 667.6,875 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 71 'ESH' at 709.2,771 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 72 'EH' at 709.2,797 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 73 'H' at 709.2,823 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 74 'H' at 709.2,849 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 75 'H' at 709.2,875 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 76 'Jacobi: 2 iterations' at 746,900 left font sprintf(',%g', scale * 10) textcolor rgb '#111111' noenhanced front
set label 77 'ESH' at 766.8,771 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 78 'ESH' at 766.8,797 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 79 'ESH' at 766.8,823 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 80 'ESH' at 766.8,849 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 81 'ESH' at 766.8,875 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 82 'ESH' at 808.4,771 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 83 'ESH' at 808.4,797 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 84 'ESH' at 808.4,823 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 85 'ES' at 808.4,849 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 86 'ESH' at 808.4,875 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 87 'ESH' at 850,771 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 88 'ESH' at 850,797 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 89 'ESH' at 850,823 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 90 'ESH' at 850,849 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 91 'ESH' at 850,875 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 92 'ESH' at 891.6,771 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 93 'ESH' at 891.6,797 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 94 'ESH' at 891.6,875 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 95 'Jacobi: 15 iterations' at 970,900 left font sprintf(',%g', scale * 10) textcolor rgb '#111111' noenhanced front
set label 96 'H' at 990.8,875 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 97 'H' at 1032.4,849 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 98 'H' at 1032.4,875 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 99 'E' at 1074,797 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 100 'EH' at 1074,823 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 101 'H' at 1074,849 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 102 'H' at 1074,875 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 103 'ES' at 1115.6,771 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 104 'E' at 1115.6,797 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 105 'EH' at 1115.6,823 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 106 'H' at 1115.6,849 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 107 'H' at 1115.6,875 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 108 'ESH' at 1157.2,771 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 109 'ESH' at 1157.2,797 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 110 'EH' at 1157.2,823 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 111 'H' at 1157.2,849 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 112 'H' at 1157.2,875 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 113 'Jacobi: 16 iterations' at 74,724 left font sprintf(',%g', scale * 10) textcolor rgb '#111111' noenhanced front
set label 114 'ESH' at 94.8,595 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 115 'ESH' at 94.8,621 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 116 'ESH' at 94.8,647 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 117 'ESH' at 94.8,673 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 118 'ESH' at 94.8,699 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 119 'ESH' at 136.4,595 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 120 'ESH' at 136.4,621 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 121 'ESH' at 136.4,647 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 122 'ESH' at 136.4,673 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 123 'ESH' at 136.4,699 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 124 'ESH' at 178,595 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 125 'ESH' at 178,621 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 126 'ESH' at 178,647 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 127 'ESH' at 178,673 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 128 'ESH' at 178,699 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 129 'ESH' at 219.6,595 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 130 'ESH' at 219.6,621 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 131 'ESH' at 219.6,647 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 132 'ESH' at 219.6,673 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 133 'ESH' at 219.6,699 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 134 'ESH' at 261.2,595 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 135 'ESH' at 261.2,621 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 136 'ESH' at 261.2,647 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 137 'ESH' at 261.2,673 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 138 'ESH' at 261.2,699 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 139 'x 10000' at 68,699 right font sprintf(',%g', scale * 9) textcolor rgb '#666666' noenhanced front
set label 140 'x 1000' at 68,673 right font sprintf(',%g', scale * 9) textcolor rgb '#666666' noenhanced front
set label 141 'x 100' at 68,647 right font sprintf(',%g', scale * 9) textcolor rgb '#666666' noenhanced front
set label 142 'x 10' at 68,621 right font sprintf(',%g', scale * 9) textcolor rgb '#666666' noenhanced front
set label 143 'x 1' at 68,595 right font sprintf(',%g', scale * 9) textcolor rgb '#666666' noenhanced front
set label 144 'Chebyshev: 16 iterations' at 298,724 left font sprintf(',%g', scale * 10) textcolor rgb '#111111' noenhanced front
set label 145 'H' at 360.4,699 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 146 'E' at 402,647 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 147 'H' at 402,673 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 148 'H' at 402,699 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 149 'E' at 443.6,621 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 150 'E' at 443.6,647 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 151 'H' at 443.6,673 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 152 'H' at 443.6,699 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 153 'E' at 485.2,595 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 154 'EH' at 485.2,621 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 155 'EH' at 485.2,647 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 156 'H' at 485.2,673 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 157 'H' at 485.2,699 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 158 'Chebyshev: interval to 1.7' at 522,724 left font sprintf(',%g', scale * 10) textcolor rgb '#111111' noenhanced front
set label 159 'Conjugate gradients: 32' at 746,724 left font sprintf(',%g', scale * 10) textcolor rgb '#111111' noenhanced front
set label 160 'H' at 808.4,699 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 161 'H' at 850,699 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 162 'E' at 891.6,647 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 163 'EH' at 891.6,673 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 164 'EH' at 891.6,699 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 165 'E' at 933.2,595 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 166 'E' at 933.2,621 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 167 'EH' at 933.2,647 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 168 'EH' at 933.2,673 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 169 'EH' at 933.2,699 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 170 'Sparse Cholesky' at 970,724 left font sprintf(',%g', scale * 10) textcolor rgb '#111111' noenhanced front
set label 171 'E' at 1115.6,673 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 172 'EH' at 1115.6,699 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 173 'E' at 1157.2,595 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 174 'E' at 1157.2,621 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 175 'E' at 1157.2,647 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 176 'E' at 1157.2,673 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 177 'EH' at 1157.2,699 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 178 'Finite elements: multilevel' at 74,548 left font sprintf(',%g', scale * 10) textcolor rgb '#111111' noenhanced front
set label 179 'H' at 178,523 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 180 'E' at 219.6,445 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 181 'H' at 219.6,471 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 182 'H' at 219.6,497 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 183 'H' at 219.6,523 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 184 'EH' at 261.2,445 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 185 'H' at 261.2,471 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 186 'H' at 261.2,497 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 187 'H' at 261.2,523 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 188 'x 10000' at 68,523 right font sprintf(',%g', scale * 9) textcolor rgb '#666666' noenhanced front
set label 189 'x 1000' at 68,497 right font sprintf(',%g', scale * 9) textcolor rgb '#666666' noenhanced front
set label 190 'x 100' at 68,471 right font sprintf(',%g', scale * 9) textcolor rgb '#666666' noenhanced front
set label 191 'x 10' at 68,445 right font sprintf(',%g', scale * 9) textcolor rgb '#666666' noenhanced front
set label 192 'x 1' at 68,419 right font sprintf(',%g', scale * 9) textcolor rgb '#666666' noenhanced front
set label 193 'XPBD: 1 substep' at 298,548 left font sprintf(',%g', scale * 10) textcolor rgb '#111111' noenhanced front
set label 194 'ES' at 318.8,419 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 195 'ES' at 318.8,445 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 196 'ES' at 318.8,471 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 197 'ES' at 318.8,497 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 198 'ES' at 318.8,523 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 199 'ESH' at 360.4,419 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 200 'ESH' at 360.4,445 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 201 'ESH' at 360.4,471 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 202 'ESH' at 360.4,497 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 203 'ESH' at 360.4,523 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 204 'ESH' at 402,419 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 205 'ESH' at 402,445 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 206 'ESH' at 402,471 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 207 'ESH' at 402,497 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 208 'ESH' at 402,523 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 209 'ESH' at 443.6,419 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 210 'ESH' at 443.6,445 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 211 'ESH' at 443.6,471 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 212 'ESH' at 443.6,497 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 213 'ESH' at 443.6,523 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 214 'ESH' at 485.2,419 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 215 'ESH' at 485.2,445 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 216 'ESH' at 485.2,471 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 217 'ESH' at 485.2,497 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 218 'ESH' at 485.2,523 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 219 'XPBD: 16 substeps' at 522,548 left font sprintf(',%g', scale * 10) textcolor rgb '#111111' noenhanced front
set label 220 'E' at 542.8,497 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 221 'E' at 542.8,523 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 222 'E' at 584.4,471 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 223 'E' at 584.4,497 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 224 'E' at 584.4,523 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 225 'E' at 626,445 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 226 'E' at 626,471 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 227 'E' at 626,497 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 228 'E' at 626,523 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 229 'E' at 667.6,445 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 230 'E' at 667.6,471 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 231 'E' at 667.6,497 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 232 'ES' at 667.6,523 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 233 'ES' at 709.2,419 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 234 'ES' at 709.2,445 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 235 'ES' at 709.2,471 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 236 'ES' at 709.2,497 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 237 'ES' at 709.2,523 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 238 'Fibres: 4 iterations' at 746,548 left font sprintf(',%g', scale * 10) textcolor rgb '#111111' noenhanced front
set label 239 'E' at 766.8,445 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 240 'E' at 766.8,471 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 241 'E' at 766.8,497 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 242 'E' at 766.8,523 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 243 'E' at 808.4,419 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 244 'E' at 808.4,445 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 245 'E' at 808.4,471 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 246 'E' at 808.4,497 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 247 'E' at 808.4,523 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 248 'ESH' at 850,419 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 249 'ESH' at 850,445 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 250 'ESH' at 850,471 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 251 'ESH' at 850,497 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 252 'ESH' at 850,523 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 253 'ESH' at 891.6,419 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 254 'ESH' at 891.6,445 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 255 'ESH' at 891.6,471 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 256 'ESH' at 891.6,497 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 257 'ESH' at 891.6,523 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 258 'ESH' at 933.2,419 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 259 'ESH' at 933.2,445 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 260 'ESH' at 933.2,471 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 261 'ESH' at 933.2,497 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 262 'ESH' at 933.2,523 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 263 '1/240' at 766.8,394 center font sprintf(',%g', scale * 9) textcolor rgb '#666666' noenhanced front
set label 264 '1/120' at 808.4,394 center font sprintf(',%g', scale * 9) textcolor rgb '#666666' noenhanced front
set label 265 '1/60' at 850,394 center font sprintf(',%g', scale * 9) textcolor rgb '#666666' noenhanced front
set label 266 '1/30' at 891.6,394 center font sprintf(',%g', scale * 9) textcolor rgb '#666666' noenhanced front
set label 267 '1/15' at 933.2,394 center font sprintf(',%g', scale * 9) textcolor rgb '#666666' noenhanced front
set label 268 'Fibres: 16 substeps' at 970,548 left font sprintf(',%g', scale * 10) textcolor rgb '#111111' noenhanced front
set label 269 'E' at 990.8,497 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 270 'E' at 990.8,523 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 271 'E' at 1032.4,471 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 272 'E' at 1032.4,497 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 273 'E' at 1032.4,523 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 274 'E' at 1074,471 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 275 'E' at 1074,497 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 276 'E' at 1074,523 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 277 'E' at 1115.6,445 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 278 'E' at 1115.6,471 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 279 'E' at 1115.6,497 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 280 'E' at 1115.6,523 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 281 'E' at 1157.2,419 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 282 'E' at 1157.2,445 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 283 'E' at 1157.2,471 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 284 'ES' at 1157.2,497 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 285 'ES' at 1157.2,523 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 286 '1/240' at 990.8,394 center font sprintf(',%g', scale * 9) textcolor rgb '#666666' noenhanced front
set label 287 '1/120' at 1032.4,394 center font sprintf(',%g', scale * 9) textcolor rgb '#666666' noenhanced front
set label 288 '1/60' at 1074,394 center font sprintf(',%g', scale * 9) textcolor rgb '#666666' noenhanced front
set label 289 '1/30' at 1115.6,394 center font sprintf(',%g', scale * 9) textcolor rgb '#666666' noenhanced front
set label 290 '1/15' at 1157.2,394 center font sprintf(',%g', scale * 9) textcolor rgb '#666666' noenhanced front
set label 291 'Symplectic Euler' at 74,372 left font sprintf(',%g', scale * 10) textcolor rgb '#111111' noenhanced front
set label 292 'x 10000' at 68,347 right font sprintf(',%g', scale * 9) textcolor rgb '#666666' noenhanced front
set label 293 'x 1000' at 68,321 right font sprintf(',%g', scale * 9) textcolor rgb '#666666' noenhanced front
set label 294 'x 100' at 68,295 right font sprintf(',%g', scale * 9) textcolor rgb '#666666' noenhanced front
set label 295 'x 10' at 68,269 right font sprintf(',%g', scale * 9) textcolor rgb '#666666' noenhanced front
set label 296 'x 1' at 68,243 right font sprintf(',%g', scale * 9) textcolor rgb '#666666' noenhanced front
set label 297 '1/240' at 94.8,218 center font sprintf(',%g', scale * 9) textcolor rgb '#666666' noenhanced front
set label 298 '1/120' at 136.4,218 center font sprintf(',%g', scale * 9) textcolor rgb '#666666' noenhanced front
set label 299 '1/60' at 178,218 center font sprintf(',%g', scale * 9) textcolor rgb '#666666' noenhanced front
set label 300 '1/30' at 219.6,218 center font sprintf(',%g', scale * 9) textcolor rgb '#666666' noenhanced front
set label 301 '1/15' at 261.2,218 center font sprintf(',%g', scale * 9) textcolor rgb '#666666' noenhanced front
set label 302 'Symplectic Euler: 64 substeps' at 298,372 left font sprintf(',%g', scale * 10) textcolor rgb '#111111' noenhanced front
set label 303 '1/240' at 318.8,218 center font sprintf(',%g', scale * 9) textcolor rgb '#666666' noenhanced front
set label 304 '1/120' at 360.4,218 center font sprintf(',%g', scale * 9) textcolor rgb '#666666' noenhanced front
set label 305 '1/60' at 402,218 center font sprintf(',%g', scale * 9) textcolor rgb '#666666' noenhanced front
set label 306 '1/30' at 443.6,218 center font sprintf(',%g', scale * 9) textcolor rgb '#666666' noenhanced front
set label 307 '1/15' at 485.2,218 center font sprintf(',%g', scale * 9) textcolor rgb '#666666' noenhanced front
set label 308 'Explicit Euler: 64 substeps' at 522,372 left font sprintf(',%g', scale * 10) textcolor rgb '#111111' noenhanced front
set label 309 '1/240' at 542.8,218 center font sprintf(',%g', scale * 9) textcolor rgb '#666666' noenhanced front
set label 310 '1/120' at 584.4,218 center font sprintf(',%g', scale * 9) textcolor rgb '#666666' noenhanced front
set label 311 '1/60' at 626,218 center font sprintf(',%g', scale * 9) textcolor rgb '#666666' noenhanced front
set label 312 '1/30' at 667.6,218 center font sprintf(',%g', scale * 9) textcolor rgb '#666666' noenhanced front
set label 313 '1/15' at 709.2,218 center font sprintf(',%g', scale * 9) textcolor rgb '#666666' noenhanced front
set label 314 'stable: none of what follows' at 108,166 left font sprintf(',%g', scale * 10) textcolor rgb '#222222' noenhanced front
set label 315 'bounded, but wrong, by one or more of these:' at 108,145 left font sprintf(',%g', scale * 10) textcolor rgb '#222222' noenhanced front
set label 316 'E  energy rose above the start''s by more than 10 % of what the start has above the still hang' at 108,124 left font sprintf(',%g', scale * 10) textcolor rgb '#222222' noenhanced front
set label 317 'S  at the end the mean stretch is off the still hang''s by more than 1 %' at 108,103 left font sprintf(',%g', scale * 10) textcolor rgb '#222222' noenhanced front
set label 318 'H  at the end the centre of mass is off the still hang''s by more than 10 cm' at 108,82 left font sprintf(',%g', scale * 10) textcolor rgb '#222222' noenhanced front
set label 319 'diverged: a particle went beyond 100 km, or at the end the mean stretch is above 200 % and the energy above the start''s by all that it had to lose' at 108,61 left font sprintf(',%g', scale * 10) textcolor rgb '#222222' noenhanced front
set label 320 'not a number, from a state that was still near and finite' at 108,40 left font sprintf(',%g', scale * 10) textcolor rgb '#222222' noenhanced front
plot NaN
set terminal pngcairo size 1194,1172 font 'DejaVu Sans,10' background rgb 'white'
set output 'stability-flat.png'
scale = GPVAL_TERM eq 'svg' ? 4.0 / 3 : 1
set label 1 '{/:Bold Where methods fail, from a flat start}' at 74,1148 left font sprintf(',%g', scale * 15) textcolor rgb '#111111' front
set label 2 'A sheet of 24 x 24 particles, 1 m, 0.2 kg/m², hung by two corners, 2 s. Across: the frame''s step [s]. Upwards: stiffness, times 400 N/m.' at 74,1124 left font sprintf(',%g', scale * 10) textcolor rgb '#666666' noenhanced front
set label 3 '{/:Bold Weft''s default}' at 74,1076 left font sprintf(',%g', scale * 10) textcolor rgb '#111111' front
set label 4 'H' at 178,1025 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 5 'H' at 219.6,1025 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 6 'H' at 219.6,1051 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 7 'H' at 261.2,999 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 8 'H' at 261.2,1025 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 9 'H' at 261.2,1051 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 10 'x 10000' at 68,1051 right font sprintf(',%g', scale * 9) textcolor rgb '#666666' noenhanced front
set label 11 'x 1000' at 68,1025 right font sprintf(',%g', scale * 9) textcolor rgb '#666666' noenhanced front
set label 12 'x 100' at 68,999 right font sprintf(',%g', scale * 9) textcolor rgb '#666666' noenhanced front
set label 13 'x 10' at 68,973 right font sprintf(',%g', scale * 9) textcolor rgb '#666666' noenhanced front
set label 14 'x 1' at 68,947 right font sprintf(',%g', scale * 9) textcolor rgb '#666666' noenhanced front
set label 15 'Multilevel: 1 pass' at 298,1076 left font sprintf(',%g', scale * 10) textcolor rgb '#111111' noenhanced front
set label 16 'H' at 402,1051 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 17 'H' at 443.6,1025 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 18 'H' at 443.6,1051 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 19 'H' at 485.2,999 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 20 'H' at 485.2,1025 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 21 'EH' at 485.2,1051 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 22 'Multilevel: 2 passes' at 522,1076 left font sprintf(',%g', scale * 10) textcolor rgb '#111111' noenhanced front
set label 23 'H' at 626,1051 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 24 'H' at 667.6,1025 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 25 'H' at 667.6,1051 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 26 'H' at 709.2,999 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 27 'H' at 709.2,1025 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 28 'H' at 709.2,1051 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 29 'Multilevel: 3 passes; BDF2' at 746,1076 left font sprintf(',%g', scale * 10) textcolor rgb '#111111' noenhanced front
set label 30 'H' at 850,1025 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 31 'H' at 891.6,1025 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 32 'H' at 891.6,1051 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 33 'H' at 933.2,999 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 34 'H' at 933.2,1025 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 35 'H' at 933.2,1051 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 36 'Multilevel: 2 passes; BDF2' at 970,1076 left font sprintf(',%g', scale * 10) textcolor rgb '#111111' noenhanced front
set label 37 'H' at 1115.6,1025 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 38 'H' at 1115.6,1051 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 39 'H' at 1157.2,999 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 40 'H' at 1157.2,1025 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 41 'H' at 1157.2,1051 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 42 'Multilevel: 6 passes' at 74,900 left font sprintf(',%g', scale * 10) textcolor rgb '#111111' noenhanced front
set label 43 'H' at 261.2,849 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 44 'H' at 261.2,875 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 45 'x 10000' at 68,875 right font sprintf(',%g', scale * 9) textcolor rgb '#666666' noenhanced front
set label 46 'x 1000' at 68,849 right font sprintf(',%g', scale * 9) textcolor rgb '#666666' noenhanced front
set label 47 'x 100' at 68,823 right font sprintf(',%g', scale * 9) textcolor rgb '#666666' noenhanced front
set label 48 'x 10' at 68,797 right font sprintf(',%g', scale * 9) textcolor rgb '#666666' noenhanced front
set label 49 'x 1' at 68,771 right font sprintf(',%g', scale * 9) textcolor rgb '#666666' noenhanced front
set label 50 'Jacobi: first guess alone' at 298,900 left font sprintf(',%g', scale * 10) textcolor rgb '#111111' noenhanced front
set label 51 'Jacobi: 1 iteration' at 522,900 left font sprintf(',%g', scale * 10) textcolor rgb '#111111' noenhanced front
set label 52 'E' at 542.8,797 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 53 'E' at 542.8,823 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 54 'EH' at 542.8,849 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 55 'H' at 542.8,875 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 56 'E' at 584.4,771 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 57 'E' at 584.4,797 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 58 'EH' at 584.4,823 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 59 'EH' at 584.4,849 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 60 'H' at 584.4,875 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 61 'E' at 626,771 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 62 'EH' at 626,797 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 63 'EH' at 626,823 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 64 'H' at 626,849 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 65 'H' at 626,875 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 66 'ESH' at 667.6,771 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 67 'ESH' at 667.6,797 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 68 'EH' at 667.6,823 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 69 'H' at 667.6,849 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 70 'H' at 667.6,875 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 71 'ESH' at 709.2,771 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 72 'EH' at 709.2,797 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 73 'H' at 709.2,823 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 74 'H' at 709.2,849 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 75 'H' at 709.2,875 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 76 'Jacobi: 2 iterations' at 746,900 left font sprintf(',%g', scale * 10) textcolor rgb '#111111' noenhanced front
set label 77 'ESH' at 766.8,771 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 78 'ESH' at 766.8,797 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 79 'ESH' at 766.8,823 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 80 'ESH' at 766.8,849 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 81 'ESH' at 766.8,875 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 82 'ESH' at 808.4,771 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 83 'ESH' at 808.4,797 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 84 'ESH' at 808.4,823 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 85 'ES' at 808.4,849 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 86 'ESH' at 808.4,875 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 87 'ESH' at 850,771 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 88 'ESH' at 850,797 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 89 'ESH' at 850,823 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 90 'ESH' at 850,849 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 91 'ESH' at 850,875 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 92 'ESH' at 891.6,771 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 93 'ESH' at 891.6,797 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 94 'ESH' at 891.6,875 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 95 'Jacobi: 15 iterations' at 970,900 left font sprintf(',%g', scale * 10) textcolor rgb '#111111' noenhanced front
set label 96 'H' at 990.8,875 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 97 'H' at 1032.4,849 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 98 'H' at 1032.4,875 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 99 'E' at 1074,797 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 100 'EH' at 1074,823 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 101 'H' at 1074,849 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 102 'H' at 1074,875 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 103 'ES' at 1115.6,771 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 104 'E' at 1115.6,797 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 105 'EH' at 1115.6,823 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 106 'H' at 1115.6,849 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 107 'H' at 1115.6,875 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 108 'ESH' at 1157.2,771 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 109 'ESH' at 1157.2,797 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 110 'EH' at 1157.2,823 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 111 'H' at 1157.2,849 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 112 'H' at 1157.2,875 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 113 'Jacobi: 16 iterations' at 74,724 left font sprintf(',%g', scale * 10) textcolor rgb '#111111' noenhanced front
set label 114 'ESH' at 94.8,595 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 115 'ESH' at 94.8,621 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 116 'ESH' at 94.8,647 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 117 'ESH' at 94.8,673 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 118 'ESH' at 94.8,699 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 119 'ESH' at 136.4,595 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 120 'ESH' at 136.4,621 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 121 'ESH' at 136.4,647 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 122 'ESH' at 136.4,673 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 123 'ESH' at 136.4,699 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 124 'ESH' at 178,595 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 125 'ESH' at 178,621 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 126 'ESH' at 178,647 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 127 'ESH' at 178,673 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 128 'ESH' at 178,699 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 129 'ESH' at 219.6,595 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 130 'ESH' at 219.6,621 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 131 'ESH' at 219.6,647 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 132 'ESH' at 219.6,673 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 133 'ESH' at 219.6,699 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 134 'ESH' at 261.2,595 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 135 'ESH' at 261.2,621 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 136 'ESH' at 261.2,647 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 137 'ESH' at 261.2,673 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 138 'ESH' at 261.2,699 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 139 'x 10000' at 68,699 right font sprintf(',%g', scale * 9) textcolor rgb '#666666' noenhanced front
set label 140 'x 1000' at 68,673 right font sprintf(',%g', scale * 9) textcolor rgb '#666666' noenhanced front
set label 141 'x 100' at 68,647 right font sprintf(',%g', scale * 9) textcolor rgb '#666666' noenhanced front
set label 142 'x 10' at 68,621 right font sprintf(',%g', scale * 9) textcolor rgb '#666666' noenhanced front
set label 143 'x 1' at 68,595 right font sprintf(',%g', scale * 9) textcolor rgb '#666666' noenhanced front
set label 144 'Chebyshev: 16 iterations' at 298,724 left font sprintf(',%g', scale * 10) textcolor rgb '#111111' noenhanced front
set label 145 'H' at 360.4,699 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 146 'E' at 402,647 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 147 'H' at 402,673 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 148 'H' at 402,699 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 149 'E' at 443.6,621 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 150 'E' at 443.6,647 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 151 'H' at 443.6,673 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 152 'H' at 443.6,699 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 153 'E' at 485.2,595 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 154 'EH' at 485.2,621 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 155 'EH' at 485.2,647 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 156 'H' at 485.2,673 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 157 'H' at 485.2,699 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 158 'Chebyshev: interval to 1.7' at 522,724 left font sprintf(',%g', scale * 10) textcolor rgb '#111111' noenhanced front
set label 159 'Conjugate gradients: 32' at 746,724 left font sprintf(',%g', scale * 10) textcolor rgb '#111111' noenhanced front
set label 160 'H' at 808.4,699 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 161 'H' at 850,699 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 162 'E' at 891.6,647 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 163 'EH' at 891.6,673 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 164 'EH' at 891.6,699 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 165 'E' at 933.2,595 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 166 'E' at 933.2,621 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 167 'EH' at 933.2,647 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 168 'EH' at 933.2,673 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 169 'EH' at 933.2,699 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 170 'Sparse Cholesky' at 970,724 left font sprintf(',%g', scale * 10) textcolor rgb '#111111' noenhanced front
set label 171 'E' at 1115.6,673 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 172 'EH' at 1115.6,699 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 173 'E' at 1157.2,595 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 174 'E' at 1157.2,621 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 175 'E' at 1157.2,647 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 176 'E' at 1157.2,673 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 177 'EH' at 1157.2,699 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 178 'Finite elements: multilevel' at 74,548 left font sprintf(',%g', scale * 10) textcolor rgb '#111111' noenhanced front
set label 179 'H' at 178,523 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 180 'E' at 219.6,445 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 181 'H' at 219.6,471 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 182 'H' at 219.6,497 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 183 'H' at 219.6,523 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 184 'EH' at 261.2,445 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 185 'H' at 261.2,471 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 186 'H' at 261.2,497 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 187 'H' at 261.2,523 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 188 'x 10000' at 68,523 right font sprintf(',%g', scale * 9) textcolor rgb '#666666' noenhanced front
set label 189 'x 1000' at 68,497 right font sprintf(',%g', scale * 9) textcolor rgb '#666666' noenhanced front
set label 190 'x 100' at 68,471 right font sprintf(',%g', scale * 9) textcolor rgb '#666666' noenhanced front
set label 191 'x 10' at 68,445 right font sprintf(',%g', scale * 9) textcolor rgb '#666666' noenhanced front
set label 192 'x 1' at 68,419 right font sprintf(',%g', scale * 9) textcolor rgb '#666666' noenhanced front
set label 193 'XPBD: 1 substep' at 298,548 left font sprintf(',%g', scale * 10) textcolor rgb '#111111' noenhanced front
set label 194 'ES' at 318.8,419 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 195 'ES' at 318.8,445 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 196 'ES' at 318.8,471 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 197 'ES' at 318.8,497 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 198 'ES' at 318.8,523 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 199 'ESH' at 360.4,419 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 200 'ESH' at 360.4,445 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 201 'ESH' at 360.4,471 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 202 'ESH' at 360.4,497 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 203 'ESH' at 360.4,523 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 204 'ESH' at 402,419 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 205 'ESH' at 402,445 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 206 'ESH' at 402,471 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 207 'ESH' at 402,497 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 208 'ESH' at 402,523 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 209 'ESH' at 443.6,419 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 210 'ESH' at 443.6,445 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 211 'ESH' at 443.6,471 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 212 'ESH' at 443.6,497 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 213 'ESH' at 443.6,523 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 214 'ESH' at 485.2,419 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 215 'ESH' at 485.2,445 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 216 'ESH' at 485.2,471 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 217 'ESH' at 485.2,497 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 218 'ESH' at 485.2,523 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 219 'XPBD: 16 substeps' at 522,548 left font sprintf(',%g', scale * 10) textcolor rgb '#111111' noenhanced front
set label 220 'E' at 542.8,497 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 221 'E' at 542.8,523 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 222 'E' at 584.4,471 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 223 'E' at 584.4,497 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 224 'E' at 584.4,523 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 225 'E' at 626,445 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 226 'E' at 626,471 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 227 'E' at 626,497 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 228 'E' at 626,523 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 229 'E' at 667.6,445 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 230 'E' at 667.6,471 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 231 'E' at 667.6,497 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 232 'ES' at 667.6,523 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 233 'ES' at 709.2,419 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 234 'ES' at 709.2,445 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 235 'ES' at 709.2,471 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 236 'ES' at 709.2,497 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 237 'ES' at 709.2,523 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 238 'Fibres: 4 iterations' at 746,548 left font sprintf(',%g', scale * 10) textcolor rgb '#111111' noenhanced front
set label 239 'E' at 766.8,445 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 240 'E' at 766.8,471 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 241 'E' at 766.8,497 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 242 'E' at 766.8,523 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 243 'E' at 808.4,419 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 244 'E' at 808.4,445 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 245 'E' at 808.4,471 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 246 'E' at 808.4,497 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 247 'E' at 808.4,523 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 248 'ESH' at 850,419 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 249 'ESH' at 850,445 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 250 'ESH' at 850,471 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 251 'ESH' at 850,497 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 252 'ESH' at 850,523 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 253 'ESH' at 891.6,419 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 254 'ESH' at 891.6,445 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 255 'ESH' at 891.6,471 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 256 'ESH' at 891.6,497 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 257 'ESH' at 891.6,523 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 258 'ESH' at 933.2,419 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 259 'ESH' at 933.2,445 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 260 'ESH' at 933.2,471 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 261 'ESH' at 933.2,497 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 262 'ESH' at 933.2,523 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 263 '1/240' at 766.8,394 center font sprintf(',%g', scale * 9) textcolor rgb '#666666' noenhanced front
set label 264 '1/120' at 808.4,394 center font sprintf(',%g', scale * 9) textcolor rgb '#666666' noenhanced front
set label 265 '1/60' at 850,394 center font sprintf(',%g', scale * 9) textcolor rgb '#666666' noenhanced front
set label 266 '1/30' at 891.6,394 center font sprintf(',%g', scale * 9) textcolor rgb '#666666' noenhanced front
set label 267 '1/15' at 933.2,394 center font sprintf(',%g', scale * 9) textcolor rgb '#666666' noenhanced front
set label 268 'Fibres: 16 substeps' at 970,548 left font sprintf(',%g', scale * 10) textcolor rgb '#111111' noenhanced front
set label 269 'E' at 990.8,497 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 270 'E' at 990.8,523 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 271 'E' at 1032.4,471 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 272 'E' at 1032.4,497 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 273 'E' at 1032.4,523 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 274 'E' at 1074,471 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 275 'E' at 1074,497 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 276 'E' at 1074,523 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 277 'E' at 1115.6,445 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 278 'E' at 1115.6,471 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 279 'E' at 1115.6,497 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 280 'E' at 1115.6,523 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 281 'E' at 1157.2,419 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 282 'E' at 1157.2,445 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 283 'E' at 1157.2,471 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 284 'ES' at 1157.2,497 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 285 'ES' at 1157.2,523 center font sprintf(',%g', scale * 9) textcolor rgb '#5c4600' noenhanced front
set label 286 '1/240' at 990.8,394 center font sprintf(',%g', scale * 9) textcolor rgb '#666666' noenhanced front
set label 287 '1/120' at 1032.4,394 center font sprintf(',%g', scale * 9) textcolor rgb '#666666' noenhanced front
set label 288 '1/60' at 1074,394 center font sprintf(',%g', scale * 9) textcolor rgb '#666666' noenhanced front
set label 289 '1/30' at 1115.6,394 center font sprintf(',%g', scale * 9) textcolor rgb '#666666' noenhanced front
set label 290 '1/15' at 1157.2,394 center font sprintf(',%g', scale * 9) textcolor rgb '#666666' noenhanced front
set label 291 'Symplectic Euler' at 74,372 left font sprintf(',%g', scale * 10) textcolor rgb '#111111' noenhanced front
set label 292 'x 10000' at 68,347 right font sprintf(',%g', scale * 9) textcolor rgb '#666666' noenhanced front
set label 293 'x 1000' at 68,321 right font sprintf(',%g', scale * 9) textcolor rgb '#666666' noenhanced front
set label 294 'x 100' at 68,295 right font sprintf(',%g', scale * 9) textcolor rgb '#666666' noenhanced front
set label 295 'x 10' at 68,269 right font sprintf(',%g', scale * 9) textcolor rgb '#666666' noenhanced front
set label 296 'x 1' at 68,243 right font sprintf(',%g', scale * 9) textcolor rgb '#666666' noenhanced front
set label 297 '1/240' at 94.8,218 center font sprintf(',%g', scale * 9) textcolor rgb '#666666' noenhanced front
set label 298 '1/120' at 136.4,218 center font sprintf(',%g', scale * 9) textcolor rgb '#666666' noenhanced front
set label 299 '1/60' at 178,218 center font sprintf(',%g', scale * 9) textcolor rgb '#666666' noenhanced front
set label 300 '1/30' at 219.6,218 center font sprintf(',%g', scale * 9) textcolor rgb '#666666' noenhanced front
set label 301 '1/15' at 261.2,218 center font sprintf(',%g', scale * 9) textcolor rgb '#666666' noenhanced front
set label 302 'Symplectic Euler: 64 substeps' at 298,372 left font sprintf(',%g', scale * 10) textcolor rgb '#111111' noenhanced front
set label 303 '1/240' at 318.8,218 center font sprintf(',%g', scale * 9) textcolor rgb '#666666' noenhanced front
set label 304 '1/120' at 360.4,218 center font sprintf(',%g', scale * 9) textcolor rgb '#666666' noenhanced front
set label 305 '1/60' at 402,218 center font sprintf(',%g', scale * 9) textcolor rgb '#666666' noenhanced front
set label 306 '1/30' at 443.6,218 center font sprintf(',%g', scale * 9) textcolor rgb '#666666' noenhanced front
set label 307 '1/15' at 485.2,218 center font sprintf(',%g', scale * 9) textcolor rgb '#666666' noenhanced front
set label 308 'Explicit Euler: 64 substeps' at 522,372 left font sprintf(',%g', scale * 10) textcolor rgb '#111111' noenhanced front
set label 309 '1/240' at 542.8,218 center font sprintf(',%g', scale * 9) textcolor rgb '#666666' noenhanced front
set label 310 '1/120' at 584.4,218 center font sprintf(',%g', scale * 9) textcolor rgb '#666666' noenhanced front
set label 311 '1/60' at 626,218 center font sprintf(',%g', scale * 9) textcolor rgb '#666666' noenhanced front
set label 312 '1/30' at 667.6,218 center font sprintf(',%g', scale * 9) textcolor rgb '#666666' noenhanced front
set label 313 '1/15' at 709.2,218 center font sprintf(',%g', scale * 9) textcolor rgb '#666666' noenhanced front
set label 314 'stable: none of what follows' at 108,166 left font sprintf(',%g', scale * 10) textcolor rgb '#222222' noenhanced front
set label 315 'bounded, but wrong, by one or more of these:' at 108,145 left font sprintf(',%g', scale * 10) textcolor rgb '#222222' noenhanced front
set label 316 'E  energy rose above the start''s by more than 10 % of what the start has above the still hang' at 108,124 left font sprintf(',%g', scale * 10) textcolor rgb '#222222' noenhanced front
set label 317 'S  at the end the mean stretch is off the still hang''s by more than 1 %' at 108,103 left font sprintf(',%g', scale * 10) textcolor rgb '#222222' noenhanced front
set label 318 'H  at the end the centre of mass is off the still hang''s by more than 10 cm' at 108,82 left font sprintf(',%g', scale * 10) textcolor rgb '#222222' noenhanced front
set label 319 'diverged: a particle went beyond 100 km, or at the end the mean stretch is above 200 % and the energy above the start''s by all that it had to lose' at 108,61 left font sprintf(',%g', scale * 10) textcolor rgb '#222222' noenhanced front
set label 320 'not a number, from a state that was still near and finite' at 108,40 left font sprintf(',%g', scale * 10) textcolor rgb '#222222' noenhanced front
plot NaN
