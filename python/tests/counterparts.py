"""Where Python has what C++ has, and what it has not, with reasons. A name that ends in .* is a type with all of its
members. Python's are written as they are used: Class.member, function(parameter), Style[setting], intervals[field]."""

SAME = """
Camera Camera.projection Camera.view Cancelled DeviceError Error FileError MismatchError UsageError
LineKind LineKind.boundary LineKind.crease LineKind.file LineKind.hatching LineKind.intersection LineKind.material
LineKind.ridge LineKind.section LineKind.silhouette LineKind.valley LineKind.tangent LineKind.centre LineKind.trail Mesh Mesh.groups Mesh.known_edges Mesh.polylines Mesh.positions Mesh.triangle_group
Mesh.polyline_object Mesh.triangle_object Mesh.triangles Pick Pick.distance Pick.kind Pick.object Pick.position
Pick.segment Pick.triangle Pick.world Renderer Scene Scene.mesh Scene.name Scene.view Style View View.eye View.far View.near View.projection
View.target View.up
"""

ELSEWHERE = {
    # cameras
    "Camera.size": "Renderer.draw(size)", "Camera.clip": "Camera(zero_to_one)", "ClipControl": "Camera(zero_to_one)",
    "ClipControl.zero_to_one": "Camera(zero_to_one)", "Projection": "View(projection)",
    "Projection.orthographic": "View(projection)", "Projection.perspective": "View(projection)", "View.fov_y": "View.fov",
    "frame_points()": "frame()", "frame_points_from()": "frame(view)",
    "Framing": "frame()", "Framing.note": "frame()", "Framing.points": "frame()", "framing_of()": "frame()",
    "ViewDirection": "frame(view)",
    "ViewDirection.toward_eye": "frame(view)", "ViewDirection.up": "frame(up)", "view_direction()": "frame(view)",
    "make_camera()": "Renderer.draw(view)", "parse_projection()": "View(projection)", "shown_height()": "View.shown_height",
    "name_of()": "View.projection",
    # sequences
    "Axis": "turntable(up)", "Axis.direction": "turntable(up)", "Axis.point": "turntable(model)", "turned()": "turntable()",
    "swept()": "turntable(size)", "CameraPath": "camera_path()", "CameraPath.Key": "camera_path(keys)",
    "CameraPath.Key.frame": "camera_path(keys)", "CameraPath.Key.view": "camera_path(keys)",
    "CameraPath.first_frame()": "camera_path()", "CameraPath.last_frame()": "camera_path()",
    "CameraPath.view()": "camera_path()",
    # devices
    "DeviceOptions": "Renderer(device)", "DeviceOptions.compute": "Renderer(compute)",
    "DeviceOptions.device": "Renderer(device)", "DeviceOptions.interop": "Renderer(interop)",
    "DeviceOptions.one_picture": "Renderer(one_picture)",
    # files
    "ImageSettings": "save()", "ImageSettings.description": "save(description)", "ImageSettings.dpi": "save(dpi)",
    "LoadedMesh": "Mesh", "LoadedMesh.mesh": "Mesh", "LoadedMesh.notes": "Mesh.notes", "LoadedMesh.origin": "Mesh.origin",
    "load_mesh()": "load()",
    "LoadOptions": "load()", "LoadOptions.deflection": "load(deflection)", "LoadOptions.pixels": "load(pixels)",
    "LoadOptions.read_memory": "load(read_memory)", "LoadOptions.read_seconds": "load(read_seconds)",
    "write_image()": "save()", "check_image_path()": "save(path)",
    "check_image_settings()": "save(dpi)",
    # lines
    "LineOptions": "Renderer(crease)", "LineOptions.crease": "Renderer(crease)", "LineOptions.lines": "Renderer(lines)",
    "LineOptions.silhouettes": "Renderer(silhouettes)", "Silhouettes.*": "Renderer(silhouettes)",
    "LineSource": "intervals[edge]", "LineSource.from": "intervals[edge]", "LineSource.to": "intervals[edge]",
    "LineSource.triangle": "intervals[triangle]", "LineSource.crossing": "intervals[crossing]",
    "extract_lines()": "Renderer()",
    # meshes
    "KnownEdge": "Mesh(known_edges)", "KnownEdge.Kind": "Mesh(known_edges)", "KnownEdge.Kind.free": "Mesh(known_edges)",
    "KnownEdge.Kind.marked": "Mesh(known_edges)", "KnownEdge.Kind.wire": "Mesh(known_edges)", "KnownEdge.Kind.seam": "Mesh(known_edges)",
    "KnownEdge.Kind.sharp": "Mesh(known_edges)", "KnownEdge.Kind.smooth": "Mesh(known_edges)",
    "KnownEdge.from": "Mesh(known_edges)", "KnownEdge.to": "Mesh(known_edges)", "KnownEdge.kind": "Mesh(known_edges)",
    "MeshArrays": "Mesh()", "MeshArrays.indices": "Mesh(triangles)", "MeshArrays.materials": "Mesh(triangle_group)",
    "MeshArrays.positions": "Mesh(positions)", "MeshGroup": "Group", "MeshGroup.color": "Group.color",
    "MeshGroup.material": "Group.material", "MeshGroup.object": "Group.object", "make_mesh()": "Mesh()",
    "ExactArrays": "Mesh()", "ExactArrays.indices": "Mesh(triangles)", "ExactArrays.materials": "Mesh(triangle_group)",
    "ExactArrays.positions": "Mesh(positions)", "ExactMesh": "Mesh", "ExactMesh.mesh": "Mesh", "ExactMesh.origin": "Mesh.origin",
    "add_polyline()": "Mesh(polylines)",
    # pictures and intervals
    "FrameOptions": "Options", "FrameOptions.forms": "Options", "StageForms": "Options", "StageForms.atlas": "Options(atlas)",
    "StageForms.depth": "Options(depth)", "FrameOptions.depth_scale": "Options(depth_scale)",
    "FrameOptions.intervals": "Renderer.intervals()", "FrameOptions.method": "Options(method)",
    "FrameOptions.probes": "Options(probes)", "FrameOptions.steady": "Options(steady)", "FrameOptions.step": "Options(step)",
    "StageForms.strokes": "Options(strokes)", "FrameOptions.style": "Renderer.draw(style)",
    "FrameOptions.draw": "Renderer.intervals()", "FrameOptions.lines": "Renderer(lines)",
    "StageForm.*": "Options(atlas)",
    "KeptIntervals.*": "Renderer.intervals(hidden)", "Method.*": "Options(method)",
    "Renderer.description()": "Renderer.description", "Renderer.draw()": "Renderer.draw()",
    "Renderer.prepare()": "Renderer.prepare()",
    "Renderer.pick()": "Renderer.pick()", "LineVisibility.pick()": "Renderer.pick()",
    "Renderer.set_transforms()": "Renderer.set_transforms()", "move_objects()": "Renderer.set_transforms()",
    "Renderer.set_positions()": "Renderer.set_positions()", "move_vertices()": "Renderer.set_positions()",
    "Assembly": "Renderer.add()", "Assembly.add()": "Renderer.add()", "Assembly.remove()": "Renderer.remove()",
    "Assembly.lines()": "Renderer.objects",
    "Renderer.set_hidden()": "Renderer.hide()", "hide_objects()": "Renderer.hide()", "LineVisibility.set_hidden()": "Renderer.hide()",
    "LineVisibility.set_positions()": "Renderer.set_positions()", "LineVisibility.set_transforms()": "Renderer.set_transforms()",
    "LineOptions.separate_objects": "Renderer(separate_objects)", "LineObject": "Renderer.objects",
    "LineObject.name": "Renderer.objects",
    "Renderer.read_intervals()": "Renderer.intervals()", "Renderer.set_lines()": "Renderer.set_model()",
    "LineVisibility": "Renderer", "LineVisibility.description()": "Renderer.description",
    "LineVisibility.find()": "Renderer.intervals()", "LineVisibility.set_lines()": "Renderer.set_model()",
    "VisibilityOptions": "Renderer.intervals()", "VisibilityOptions.hidden": "Renderer.intervals(hidden)",
    "VisibilityOptions.lines": "Renderer(lines)", "VisibilityOptions.step": "Options(step)",
    # scenes and sections
    "make_scene()": "scene()", "scene_names()": "SCENES",
    "Hatching": "Mesh.cut()", "Hatching.angle": "Mesh.cut(angle)", "Hatching.none": "Mesh.cut(hatching)",
    "Hatching.spacing": "Mesh.cut(spacing)", "Section": "Mesh.cut()", "Section.mesh": "Mesh.cut()", "Section.notes": "Mesh.notes",
    "Explosion": "Mesh.exploded()", "Explosion.factor": "Mesh.exploded(factor)", "Explosion.moves": "Mesh.exploded(moves)",
    "Explosion.trails": "Mesh.exploded(trails)", "PartMove.*": "Mesh.exploded(moves)", "explode()": "Mesh.exploded()",
    "SectionPlane.*": "Mesh.cut(planes)", "cut_mesh()": "Mesh.cut()", "parse_section()": "Mesh.cut(planes)",
    # styles
    "Style.more_lines": "Style[more-lines]", "Style.centre_overhang": "Style[centre-overhang]", "Style.density": "Style[density]", "Style.fill": "Style[fill]", "Style.filter": "Style[drop-runs]",
    "Style.focus": "Style[focus]", "Style.hidden": "Style[hidden]", "Style.hidden_density": "Style[hidden-density]", "Style.hidden_pen": "Style[hidden-pen]",
    "Style.paper": "Style[paper]", "Style.pen": "Style[pen]",
    "Cap.*": "Style[cap]", "FillMode.*": "Style[fill]", "Join.*": "Style[join]",
    "Pen": "Style[pen]", "Pen.cap": "Style[cap]", "Pen.cap_length": "Style[cap-length]", "Pen.color": "Style[color]",
    "Pen.join": "Style[join]", "Pen.mark": "Style[pen]", "Pen.mitre_limit": "Style[mitre-limit]",
    "Pen.opacity": "Style[opacity]", "Pen.opacity_profile": "Style[opacity-profile]", "Pen.path_cap": "Style[path-cap]",
    "Pen.width": "Style[width]", "Pen.width_profile": "Style[width-profile]",
    "Fill": "Style[fill]", "Fill.ambient": "Style[ambient]", "Fill.color": "Style[fill-color]", "Fill.light": "Style[light]",
    "Fill.mode": "Style[fill]", "Fill.toon_steps": "Style[toon-steps]",
    "Paper": "Style[paper]", "Paper.color": "Style[paper]", "Paper.grain": "Style[paper-grain]",
    "Focus": "Style[focus]", "Focus.density": "Style[focus-density]", "Focus.falloff": "Style[focus-falloff]",
    "Focus.hidden_opacity": "Style[focus-hidden-opacity]", "Focus.in_scene": "Style[focus]", "Focus.mark": "Style[focus-pen]",
    "Focus.on": "Style[focus]", "Focus.opacity": "Style[focus-opacity]", "Focus.point": "Style[focus]",
    "Focus.radius": "Style[focus-radius]", "Focus.width": "Style[focus-width]",
    "Style.pens": "Style[pens]", "PenRule.*": "Style[pens]", "PenMatch.*": "Style[pens]", "Style.made_for": "Style[made-for]",
    "default_frame_options()": "Options", "default_style()": "Renderer.draw(style)",
    "StyleInfo": "styles()", "StyleInfo.description": "styles()", "StyleInfo.name": "styles()", "list_styles()": "styles()",
    "apply_setting()": "Style.__setitem__()", "load_style()": "Style()", "write_style()": "Style.to_toml()",
    # paths
    "DxfOptions": "Renderer.to_dxf()", "DxfOptions.fit_arcs": "Renderer.to_dxf(fit_arcs)", "DxfOptions.curves": "Renderer.to_dxf(curves)",
    "DxfOptions.margin": "Renderer.to_dxf(margin)", "DxfOptions.page": "Renderer.to_dxf(page)",
    "JsonOptions": "Renderer.to_json()", "JsonOptions.tags": "Renderer.to_json(tags)",
    "SvgOptions": "Renderer.to_svg()", "SvgOptions.background": "Renderer.to_svg(transparent)",
    "SvgOptions.curves": "Renderer.to_svg(curves)", "VectorCurve.*": "Renderer.to_json()", "VectorCubic.*": "Renderer.to_json()",
    "VectorArc.*": "Renderer.to_json()",
    "SvgOptions.fit_arcs": "Renderer.to_svg(fit_arcs)", "SvgOptions.margin": "Renderer.to_svg(margin)",
    "SvgOptions.page": "Renderer.to_svg(page)", "SvgOptions.tags": "Renderer.to_svg(tags)",
    "SvgOptions.title": "Renderer.to_svg(title)", "SvgOptions.units": "Renderer.to_svg(page)",
    "OutlinePart.*": "Renderer.to_json()", "LineVisibility.outlines()": "Renderer.to_json()",
    "Renderer.read_outlines()": "Renderer.to_json()", "VectorOptions.outlines": "Renderer.to_json()",
    "VisibilityOptions.outlines": "Renderer.to_json()",
    "VisibilityOptions.outline_depth": "Renderer.to_json()", "VisibilityOptions.centre_overhang": "Style[centre-overhang]",
    "VectorOptions": "Renderer.to_svg()", "VectorOptions.mesh": "Renderer.to_svg(tags)",
    "VectorOptions.plotter": "Renderer.to_svg(plotter)", "Page.*": "Renderer.to_svg(page)", "Unit.*": "Renderer.to_svg(page)",
    "Length.*": "Renderer.to_svg(margin)", "length_in()": "Renderer.to_svg(margin)", "parse_length()": "Renderer.to_svg(margin)",
    "style_on_page()": "Renderer.to_svg(page)",
    "parse_page()": "Renderer.to_svg(page)", "parse_unit()": "Renderer.to_svg(margin)",
    "VectorDrawing.*": "Renderer.to_json()", "VectorPath.*": "Renderer.to_json()", "VectorPiece.*": "Renderer.to_json()",
    "VectorPoint.*": "Renderer.to_json()", "make_vector_drawing()": "Renderer.to_json()", "to_dxf()": "Renderer.to_dxf()",
    "find_fills()": "Renderer.to_json()", "VectorFill.*": "Renderer.to_json()",
    "to_json()": "Renderer.to_json()", "to_svg()": "Renderer.to_svg()",
    # sheets
    "ProjectionAngle.*": "Renderer.to_sheet(angle)", "parse_projection_angle()": "Renderer.to_sheet(angle)",
    "SheetFields.*": "Renderer.to_sheet(fields)", "set_field()": "Renderer.to_sheet(fields)",
    "SheetOptions": "Renderer.to_sheet()", "SheetOptions.views": "Renderer.to_sheet(views)",
    "SheetOptions.details": "Renderer.to_sheet(details)", "SheetDetail.*": "Renderer.to_sheet(details)",
    "SheetOptions.placements": "Renderer.to_sheet(views)", "SheetPlacement.*": "Renderer.to_sheet(views)",
    "load_sheet()": "Renderer.to_sheet(views)", "parse_detail()": "Renderer.to_sheet(details)",
    "SheetOptions.angle": "Renderer.to_sheet(angle)", "SheetOptions.page": "Renderer.to_sheet(page)",
    "SheetOptions.scale": "Renderer.to_sheet(scale)", "SheetOptions.unit": "Renderer.to_sheet(unit)",
    "SheetOptions.up": "Renderer.to_sheet(up)", "SheetOptions.origin": "Mesh.origin", "SheetOptions.fields": "Renderer.to_sheet(fields)",
    "SheetOptions.measures": "Renderer.to_sheet(measures)", "parse_views()": "Renderer.to_sheet(views)",
    "SheetWriting": "Renderer.to_sheet()", "SheetWriting.background": "Renderer.to_sheet(transparent)",
    "SheetWriting.tags": "Renderer.to_sheet(tags)", "SheetWriting.curves": "Renderer.to_sheet(curves)",
    "SheetWriting.fit_arcs": "Renderer.to_sheet(fit_arcs)", "make_vector_sheet()": "Renderer.to_sheet()",
    "lay_out_sheet()": "Renderer.to_sheet()", "VectorSheet": "Renderer.to_sheet()",
    "VectorSheet.layout": "Renderer.to_sheet()", "VectorSheet.drawings": "Renderer.to_sheet()",
    "SeenLines.*": "Renderer.intervals()", "enclosed_volume()": "Mesh.volume",
}

# Names without a counterpart, by reason.
NOT_IN_PYTHON = {
    "NumPy does it in a line": """
        Camera.clip_from_world() Bounds.* bounds_of() Mesh.empty() MeshArrays.stride ExactArrays.stride Pixels.* Image.* read_image()""",
    "a part of drawing into a program's own framebuffer, which the package does not offer": """
        Camera.origin ClipControl.upper_left DepthTexture.* FrameOptions.own_depth HeadlessContext.* Renderer.tile_size()
        Renderer.draw_tiles() PictureTile.* TileTarget.* Renderer.set_pen_image()""",
    "for those who look after devices, with tools of their own in C++": """
        DeviceOptions.compare_until DeviceOptions.compare_with Renderer.comparison() Renderer.Comparison.*
        Renderer.Samples.* Renderer.read_samples() Renderer.set_device() FrameOptions.cull_hidden""",
    "for programs in C++ that have OpenMesh themselves": """
        OpenMeshModel.* OpenMeshNormals.* OpenMeshOptions.* add_polygon()""",
    "said by warnings": "Renderer.note()",
    "figures of a frame, which `lineatlas draw --stats`, --profile and --kernels give": """
        FrameStats.* StageTime.* FrameOptions.measure_stages FrameOptions.profile Renderer.tables() Renderer.take_profiles() FrameProfile.*
        ProfileEvent.* ProfileTrack.* StageShare.* profile_csv() profile_table() profile_trace() stage_shares()
        Bound Bound.* KernelResources KernelResources.* KernelTime.* LaunchCounts.* PerfCounts.* Roofs.* measure_arithmetic() kernel_csv() kernel_json() kernel_table() kernel_times()
        kernel_trace() register_counting_device() register_perf_device() roofline_svg() take_launch_counts() take_perf_counts()
        why_no_perf_events()
        LineTimes.* LeftOut.* OddTriangles.*""",
    "numbers of vertices, which Python does not see": "LineObject.first_vertex LineObject.vertex_count",
    "not bound yet: what files say beside their mesh, and how they are read": """
        LoadedMesh.deflection LoadedMesh.format LoadedMesh.parts LoadedMesh.unit LoadedMesh.up ModelPart.* KnownEdge.edge
        LineOptions.smooth_edges ImageSettings.bits Mesh.precision""",
    "not bound yet: normals and curves of a program's own": "Mesh.corner_normals Mesh.edge_curves EdgeCurve.* "
        "Mesh.edge_entities Mesh.surfaces KnownSurfaces.* PlacedSurface.* SurfaceShape.* SurfaceCurve.* SplineDirection.* is_sound()",
    "a choice that nobody has asked for": """
        LineOptions.chain_angle SvgOptions.layers SvgOptions.relative SvgOptions.description JsonOptions.description
        DxfOptions.description VectorOptions.tolerance with_shown_height() SheetWriting.layers SheetWriting.description""",
    "what a sheet is made of, which comes as a file": """
        SheetLayout.* SheetView.* SheetLine.* SheetCircle.* SheetText.* TextAnchor.* VectorSheet.model_size style_of_view()""",
    "the table of lines itself stays within: intervals say where each comes from": "LineSet.* CutVertex.* Contours.*",
    "kinds of polylines come with Mesh.cut(), a program's own are LineKind.file": "Mesh.polyline_kind PolylineKind.*",
    "written by `lineatlas draw` alone": """
        DxfOptions.certificate JsonOptions.certificate SvgOptions.certificate JsonOptions.origin PenTravel.*""",
}
