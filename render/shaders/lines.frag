out vec4 pixel;

void main() { pixel = vec4(0.02, 0.02, 0.03, 0.55); }
