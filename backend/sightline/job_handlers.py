"""Every kind of background work: importing a module registers its handler."""

from importlib import import_module

MODULES = tuple(
    import_module(f"sightline.{name}")
    for name in (
        "recordings.calibrating.calibrate_job",
        "demo.demo_job",
        "demo.study_job",
        "export.export_job",
        "scans.again.again_job",
        "poses.pose_job",
        "quality.drift.drift_job",
        "recordings.ingest_job",
        "recordings.tidy_job",
        "scans.read_job",
        "scans.vehicles.find_job",
        "studies.study_job",
        "vehicles.passes.find_job",
        "vehicles.proposing.propose_job",
    )
)
