#version 450 core

in vec4 paint;
layout(location = 0) out vec4 colour;

void main() { colour = paint; }
