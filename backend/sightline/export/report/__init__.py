"""Drawing for print: figures as SVG and the report as PDF, from dataclasses to bytes, always alike."""
