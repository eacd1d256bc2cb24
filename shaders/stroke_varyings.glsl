// strokes: what the fragment shader knows of its run. VARYING is `out` or `in`. Values that are the same
// all along a run are computed once per run. The linker leaves out those that a style has no use for.

noperspective VARYING vec2 local; // pixels along the run from its start, and across it to the left
flat VARYING uvec4 run_samples;   // atlas address, last sample; as bits: sample at the start, per pixel
flat VARYING vec4 run_line;       // round beyond the first two, pixels; arc length at start, per pixel
flat VARYING vec4 run_cuts;       // cut square at the first two, pixels; length; 1: visible all along
flat VARYING vec4 run_window;     // window position of the start, direction
flat VARYING uint run_priority;   // of the line, for `density`
flat VARYING vec3 start_bevel;    // direction out of the corner, 1 - cosine of half the turn; or 0
flat VARYING vec3 end_bevel;
flat VARYING vec3 stroke_taper; // arc lengths of the points; 1 / length of a tapered end
flat VARYING vec2 stroke_dry;   // arc lengths of the textured ends
flat VARYING vec2 stroke_share; // of the whole stroke's length: at the run's start, per pixel
flat VARYING vec4 focus_start;  // the run's start as seen from the focus, homogeneous
flat VARYING vec4 focus_way;    // what is added to focus_start per pixel
