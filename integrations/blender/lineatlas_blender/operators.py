"""lineatlas.draw: the lines of a frame, or of the scene's frame range."""

import bpy
from bpy.props import BoolProperty

from .errors import DrawingError
from .job import Job


def job_of(context, animation):
    scene = context.scene
    settings, frames = scene.lineatlas, None
    if animation:
        frames = list(range(scene.frame_start, scene.frame_end + 1, scene.frame_step))
    return Job(scene=scene, view_layer=context.view_layer, lines=settings.lines(), frames=frames,
               picture=settings.picture, svg=settings.svg, strokes=settings.strokes, compose=settings.compose)


class LINEATLAS_OT_draw(bpy.types.Operator):
    """Draw the lines of the scene as its camera sees them"""

    bl_idname = "lineatlas.draw"
    bl_label = "Draw Lines"
    bl_options = {"REGISTER"}

    animation: BoolProperty(name="Animation", default=False, options={"SKIP_SAVE"},
                            description="All frames of the scene's range")

    def begin(self, context):
        self.job = job_of(context, self.animation)
        self.steps = self.job.steps()

    def step(self):
        """Draws a frame. Whether there are more; an error is reported and raised no further."""
        try:
            self.done = next(self.steps)
            return {"RUNNING_MODAL"}
        except StopIteration:
            self.say_what_was_done()
            return {"FINISHED"}
        except DrawingError as error:
            self.report({"ERROR"}, str(error))
        except Exception as error:  # of the package: one line each; of Blender: what it says
            self.report({"ERROR"}, f"lines can't be drawn: {error}")
        return {"CANCELLED"}

    def say_what_was_done(self):
        for note in self.job.notes:
            self.report({"WARNING"}, note)
        frames, files = len(self.job.numbers()), self.job.files
        what = f"{frames} frame{'s' if frames > 1 else ''} drawn"
        self.report({"INFO"}, f"{what}: {files[-1]}" if files else what)

    def execute(self, context):
        self.begin(context)
        status = {"RUNNING_MODAL"}
        while status == {"RUNNING_MODAL"}:
            status = self.step()
        return status

    def invoke(self, context, event):
        self.begin(context)
        manager = context.window_manager
        manager.progress_begin(0, len(self.job.numbers()))
        self.timer = manager.event_timer_add(0.01, window=context.window)
        self.say_progress(context, 0)
        manager.modal_handler_add(self)
        return {"RUNNING_MODAL"}

    def modal(self, context, event):
        if event.type == "ESC":
            self.steps.close()
            self.report({"INFO"}, "Stopped; what was drawn so far stays")
            return self.end(context, {"CANCELLED"})
        if event.type != "TIMER":
            return {"PASS_THROUGH"}
        status = self.step()
        if status != {"RUNNING_MODAL"}:
            return self.end(context, status)
        self.say_progress(context, self.done)
        return status

    def say_progress(self, context, done):
        context.window_manager.progress_update(done)
        context.workspace.status_text_set(f"Drawing lines: {done} of {len(self.job.numbers())} frames (Esc stops)")

    def end(self, context, status):
        context.window_manager.event_timer_remove(self.timer)
        context.window_manager.progress_end()
        context.workspace.status_text_set(None)
        return status
